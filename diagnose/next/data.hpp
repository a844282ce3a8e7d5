#pragma once
/// \file
/// The measured values of an experiment, as they were read, each with its place.

#include <Eigen/Core>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose::next {

using Eigen::VectorXd;
using Eigen::MatrixXd;

/// The values of one channel in one run, in the order in which they were read.
struct Sequence {
  std::size_t run;
  Eigen::Index first, count;  ///< in the block
};

/// The values of one channel in all runs.
struct Block {
  Channel channel;
  std::vector<Sequence> sequences;
  std::vector<std::size_t> run, reading;  ///< by value
  VectorXd value;                           ///< SI
  VectorXd sigma;                           ///< declared, of each value, SI
  VectorXd time;                            ///< s
  [[nodiscard]] Eigen::Index size() const { return value.size(); }
};

/// What was measured; nothing of it ever changes.
class Data {
 public:
  explicit Data(const Experiment& experiment);

  [[nodiscard]] const std::vector<Block>& blocks() const { return blocks_; }
  [[nodiscard]] Eigen::Index size() const;
  /// (measured - predicted) / declared sigma, by block.
  [[nodiscard]] std::vector<VectorXd> residual(const Prediction& predicted) const;
  /// What traces (one a run) hold at the values, over the declared sigma, by block.
  [[nodiscard]] std::vector<VectorXd> in_sigmas(const std::vector<Trace>& traces) const;

 private:
  std::vector<Block> blocks_;
};

}  // namespace plumbline::diagnose::next
