#pragma once
/// \file
/// The measured values of an experiment, as they were read, each with its place. Nothing of them ever
/// changes.

#include <Eigen/Core>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

using Eigen::MatrixXd, Eigen::VectorXd;

/// The values of one channel in one run, in the order in which they were read.
struct Series {
  std::size_t run;
  Channel channel;
  std::size_t first;                  ///< place of its first value in the flat list
  std::vector<std::size_t> readings;  ///< of each value: the number of its reading in the run
};

/// The values of one channel in all runs: neighbours in the flat list.
struct Block {
  Channel channel;
  Eigen::Index first, count;
  std::vector<std::size_t> series;  ///< their numbers
};

/// A value's reading.
struct ReadingPlace {
  std::size_t run, reading;
};

/// Every vector of residuals in the diagnosis is in the order of this flat list: channel by channel, in each
/// run by run.
class Measurements {
 public:
  explicit Measurements(const Experiment& experiment);

  [[nodiscard]] const std::vector<Series>& series() const { return series_; }
  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] std::size_t size() const { return places_.size(); }
  /// By value.
  [[nodiscard]] const std::vector<ReadingPlace>& places() const { return places_; }
  /// By value: as it was read, and its declared standard deviation, SI, with what the nominal model passes on
  /// of the noise of imposed channels; when it was read, s.
  [[nodiscard]] const VectorXd& value() const { return value_; }
  [[nodiscard]] const VectorXd& sigma() const { return sigma_; }
  [[nodiscard]] const VectorXd& time() const { return time_; }

  /// Whether time stamps of a run tell more than the number of a reading.
  [[nodiscard]] bool has_clock(std::size_t run) const { return clock_[run]; }

  /// (measured - predicted) / declared sigma, flat.
  [[nodiscard]] VectorXd residual(const Prediction& predicted) const;
  /// The values of traces (one a run) at the measured values, over the declared sigma, flat.
  [[nodiscard]] VectorXd in_sigmas(const std::vector<Trace>& traces) const;

 private:
  std::vector<Series> series_;
  std::vector<Block> blocks_;
  std::vector<ReadingPlace> places_;
  VectorXd value_, sigma_, time_;
  std::vector<bool> clock_;  ///< by run
};

}  // namespace plumbline::diagnose
