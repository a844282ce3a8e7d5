#pragma once
/// \file
/// The prediction of an experiment with a given rig, along the loading history of every run.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The channels of a reading, as columns of a trace: x, y, Fx, Fy, Fx_2, Fy_2, q_1 … q_n.
enum ChannelColumn : Eigen::Index {
  column_x,
  column_y,
  column_Fx,
  column_Fy,
  column_Fx_2,
  column_Fy_2,
  column_q
};

/// Joints of an arm in space, at most: the columns of its points and torques come behind so many angles.
inline constexpr std::size_t most_arm_joints = 24;

inline Eigen::Index column_of(const Channel& channel) {
  using Name = Channel::Name;
  constexpr auto behind_angles = static_cast<std::size_t>(column_q) + most_arm_joints;
  if (channel.name == Name::angle) return column_x;
  if (channel.name == Name::torque) return column_Fx;
  if (channel.name == Name::torque_2) return column_Fx_2;
  if (channel.name == Name::drive) return static_cast<Eigen::Index>(behind_angles + channel.joint);
  if (channel.name == Name::place || channel.name == Name::turn)
    return static_cast<Eigen::Index>(behind_angles + most_arm_joints + 2 * channel.joint +
                                     (channel.name == Name::turn ? 1 : 0));
  return static_cast<Eigen::Index>(static_cast<std::size_t>(channel.name) + channel.joint);
}

/// The prediction of one run: a row a reading, a column a channel. Imposed channels repeat the command.
using Trace = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The circumstances of a reading that user corrections may depend on.
struct Moment {
  double t;         ///< in the run, s
  std::size_t run;  ///< its number, from 0
  double
      direction;  ///< 1 or -1: of the joint for a joint angle, else of the command along the channel's axis
  double rest;    ///< rest angle of that joint
  std::span<const double> covariates = {};  ///< of the reading
};

/// The values of the variables of a channel's correction: reading_variables, angle_variables, covariates.
std::vector<double> reading_values(const Eigen::Ref<const Eigen::ArrayXd>& row, const Moment& moment,
                                   const Channel& channel);

/// All runs of an experiment.
struct Prediction {
  /// False where the rig cannot follow the experiment: an end point out of reach, or no stable posture.
  bool reached = true;
  bool snapped = false;                         ///< some run snapped
  std::vector<Trace> runs;                      ///< one a run; NaN beyond the reading that was not reached
  std::vector<std::vector<Trace>> sensitivity;  ///< [parameter][run]: derivative by the fitted coordinate
};

/// A rig with a small step in one parameter.
struct RigVariation {
  Rig rig;
  double step;
};

/// Predicts all runs, and the difference quotients by the variations.
Prediction simulate(const Experiment& experiment, const Rig& rig,
                    const std::vector<RigVariation>& variations);

}  // namespace plumbline::diagnose
