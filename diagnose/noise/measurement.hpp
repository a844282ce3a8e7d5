#pragma once
/// \file
/// The measured values of an experiment as one flat list, and the series that they form.

#include <cstddef>
#include <vector>

#include "diagnose/noise/differences.hpp"
#include "diagnose/rig/history.hpp"
#include "diagnose/noise/repeats.hpp"

namespace plumbline::diagnose {

/// Where each measured value of an experiment stands. The flat list holds the series one after the other;
/// every vector of residuals in the diagnosis is in this order.
class Measurements {
 public:
  explicit Measurements(const Experiment& experiment);

  [[nodiscard]] const std::vector<Series>& series() const { return series_; }
  /// What was read in runs that go the same way.
  [[nodiscard]] const std::vector<Repeats>& repeats() const { return repeats_; }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// (measured - predicted) / sigma of the value, flat.
  [[nodiscard]] std::vector<double> residual(const Experiment& experiment, const Prediction& predicted) const;

  /// What the traces (one a run) hold at the measured values, over the sigma of the value, flat.
  [[nodiscard]] std::vector<double> in_sigmas(const std::vector<Trace>& traces) const;

 private:
  void weigh_groups(Sensor sensor, std::size_t (*group_of)(const Series&), double Series::*beside_others,
                    std::vector<SeenNoise>& seen);
  void weigh_stretches(const Experiment& experiment, const std::vector<std::vector<double>>& values,
                       std::vector<SeenNoise>& seen);
  void weigh(const std::vector<std::vector<double>>& values, const std::vector<SeenNoise>& seen);

  std::vector<Series> series_;
  std::vector<Repeats> repeats_;
  std::size_t size_ = 0;
};

}  // namespace plumbline::diagnose
