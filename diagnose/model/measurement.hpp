#pragma once
/// \file
/// The measured values of an experiment as one flat list, and the series that they form.

#include <cstddef>
#include <string>
#include <vector>

#include "diagnose/model/history.hpp"

namespace plumbline::diagnose {

/// What kind of sensor a value comes from: each kind shares one correction of its declared noise.
enum class Sensor { position, force, angle };

/// How many names of channels there are: x, y, Fx, Fy, q.
inline constexpr std::size_t channel_names = 5;

/// A column of a sample file that carries measured values.
struct Channel {
  enum class Name { x, y, Fx, Fy, q } name;
  std::size_t joint;  ///< 0-based; meaningful for q

  bool operator==(const Channel&) const = default;
  [[nodiscard]] Sensor sensor() const;
  [[nodiscard]] std::string label() const;  ///< "Fx", or "q3" (1-based)
  [[nodiscard]] double of(const Reading& reading) const;
  [[nodiscard]] Eigen::Index column() const;  ///< in a predicted trace
  [[nodiscard]] double sigma(const Noise& noise) const;
};

/// The values of one channel in one run, in the order in which they were taken, without the missing ones.
struct Series {
  std::size_t run;
  Channel channel;
  double sigma;                       ///< declared noise
  std::size_t first;                  ///< place of its first value in the flat list
  std::vector<std::size_t> readings;  ///< index of each value's reading in the run
};

/// Where each measured value of an experiment stands. The flat list holds the series one after the other;
/// every vector of residuals in the diagnosis is in this order.
class Measurements {
 public:
  explicit Measurements(const Experiment& experiment);

  [[nodiscard]] const std::vector<Series>& series() const { return series_; }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// (measured - predicted) / declared sigma, flat.
  [[nodiscard]] std::vector<double> residual(const Experiment& experiment, const Prediction& predicted) const;

  /// What the traces (one a run) hold at the measured values, over the declared sigma, flat.
  [[nodiscard]] std::vector<double> in_sigmas(const std::vector<Trace>& traces) const;

 private:
  std::vector<Series> series_;
  std::size_t size_ = 0;
};

}  // namespace plumbline::diagnose
