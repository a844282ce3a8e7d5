#pragma once
/// \file
/// The nominal model of an arm in space: its mechanics, and the names and limits that its model file gives.

#include <array>
#include <plumbline/arm/arm_kinematics.hpp>
#include <string>
#include <vector>

namespace plumbline::diagnose {

/// Lists are by link, from the base on; link i is moved by joint i.
struct NominalArm {
  SerialArm<double> arm;
  std::string base, tip;                        ///< names of the links or frames at its ends
  std::vector<std::string> joint, link;         ///< names
  std::vector<std::array<double, 2>> limits{};  ///< of joint coordinates, rad or m; infinite without
};

/// The pose of a frame of the arm that no joint or link yields: by it orientations are told.
Pose<double> nominal_pose(const SerialArm<double>& arm, const OnLink<double>& point,
                          const std::vector<double>& command);

}  // namespace plumbline::diagnose
