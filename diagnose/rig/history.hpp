#pragma once
/// \file
/// What an experiment would have measured if its rig had given effects: the whole loading history of every
/// run.

#include <Eigen/Core>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The channels of a reading, as columns of a trace: x, y, Fx, Fy, q_1 … q_n.
enum ChannelColumn : Eigen::Index { column_x, column_y, column_Fx, column_Fy, column_q };

inline Eigen::Index column_of(const Channel& channel) {
  return static_cast<Eigen::Index>(static_cast<std::size_t>(channel.name) + channel.joint);
}

/// One run as predicted: a row a reading, a column a channel. Imposed channels repeat what was commanded.
using Trace = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// When a channel is read, and on which way.
struct Moment {
  double t;         ///< in the run, s
  std::size_t run;  ///< its number, from 0
  double
      direction;  ///< 1 or -1: of a joint, where its angle is read, else of what is imposed along that axis
  double rest;    ///< angle of that joint at rest
};

/// What the variables of a correction of a channel are: see reading_variables, angle_variables.
std::vector<double> reading_values(const Eigen::Ref<const Eigen::ArrayXd>& row, const Moment& moment,
                                   const Channel& channel);

/// All runs of an experiment.
struct Prediction {
  /// False where the rig cannot follow the experiment: a commanded end point out of reach, or no stable
  /// posture.
  bool reached = true;
  bool snapped = false;                         ///< some run went through a snap
  std::vector<Trace> runs;                      ///< one a run; NaN where the rig did not get
  std::vector<std::vector<Trace>> sensitivity;  ///< [parameter][run]: derivative by the fitted coordinate
};

/// A rig that differs by a small step in one parameter.
struct RigVariation {
  Rig rig;
  double step;
};

/// Predicts what a rig would give and, beside it, the difference quotients of its variations.
Prediction simulate(const Experiment& experiment, const Rig& rig,
                    const std::vector<RigVariation>& variations);

}  // namespace plumbline::diagnose
