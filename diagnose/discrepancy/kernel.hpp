#pragma once
/// \file
/// The prior of a discrepancy: a Gaussian process of what was commanded, of the direction in which it was
/// commanded, and of the run; small at rest (Kennedy and O'Hagan 2001).

#include <Eigen/Core>
#include <vector>

#include "diagnose/inference/measurements.hpp"

namespace plumbline::diagnose {

/// A reading in the coordinates of the process.
struct CommandState {
  /// What was commanded: from rest, over the largest of its kind of control. An arm in space has an entry for
  /// each joint that moves, and one for its load: what is beside the model is a sum of functions of each.
  std::vector<Eigen::Vector3d> command{{0, 0, 0}};
  std::vector<double> direction{1};  ///< of each: 1 away from rest, -1 back
  /// Way covered in the run until then, over the longest of any run. Of an arm, whose runs are parts of one
  /// session, the number of readings until then, over all.
  double progress = 0;
};

/// The states of all readings, and how alike the runs are.
struct CommandStates {
  explicit CommandStates(const Experiment& experiment);
  std::vector<std::vector<CommandState>> of;  ///< [run][reading]
  MatrixXd alike;                             ///< of runs, in [0, 1]: by control and rest shape
  /// By run, whether its command tells when nothing is loaded. In a sag test without forces none does.
  std::vector<bool> knows_rest;
  bool one_session = false;  ///< progress counts on from run to run

 private:
  void add_ways(const Experiment& experiment);
  void add_poses(const Experiment& experiment);
};

/// A basis for the discrepancies of a block at several correlation lengths: columns C C' is the covariance of
/// each length at the values, where C C' = phi G phi', but for a small share of its trace.
struct DiscrepancyBasis {
  MatrixXd phi;                      ///< values x columns
  std::vector<MatrixXd> covariance;  ///< G of each length
};

/// \param lengths  over the largest command, ascending
DiscrepancyBasis discrepancy_basis(const CommandStates& states, const Measurements& measurements,
                                   const Block& block, const std::vector<double>& lengths);

}  // namespace plumbline::diagnose
