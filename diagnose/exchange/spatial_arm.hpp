#pragma once
/// \file
/// From the bodies and joints of a simulator's model to a serial arm in space.

#include <string>
#include <vector>

#include "diagnose/bench/nominal_arm.hpp"
#include "diagnose/bench/nominal_chain.hpp"
#include "diagnose/exchange/arm_path.hpp"

namespace plumbline::exchange {

struct SpatialArm {
  diagnose::NominalArm nominal;
  std::vector<Eigen::Matrix3d> inertia;          ///< by link, about the origin of its frame, kg m^2
  std::vector<std::string> notes;                ///< what was assumed, what was left out
  std::vector<double> friction;                  ///< by joint: torque or force at which it slips
  std::vector<diagnose::NominalEffect> effects;  ///< friction, as the catalogue has it
  std::vector<std::size_t> joints;               ///< numbers among those of the model
};

/// The arm from base to tip. A link's frame has the axes of the body that its joint moves, and its origin on
/// the axis of the joint. What hangs on a link beside the path weighs with it, its joints held as the model
/// draws them. A joint yields by the servo that holds it; without one, by its spring.
/// \param source  named in errors
/// \throws Error, one line, as ArmPath does; where a joint of the path is no hinge or slide, follows another,
///         or has limits in degrees; and where bodies of different links are tied
SpatialArm spatial_arm(const ReadModel& model, const std::string& source, const ArmEnds& ends = {});

}  // namespace plumbline::exchange
