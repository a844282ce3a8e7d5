#pragma once
/// \file
/// A simulator's model of an arm with what was found.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/exchange/model.hpp"
#include "diagnose/exchange/spatial_arm.hpp"

namespace plumbline::exchange {

/// A mass at a point.
struct PointMass {
  double mass = 0;  ///< kg
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};

/// The difference between it and the arm of the file is what the file's text is to be corrected by. A wrong
/// zero of a joint is a turn of its link's frame about its axis.
struct CorrectedArm {
  std::string title;                  ///< one line, for the head of the file
  std::filesystem::path source;       ///< the model's file
  ArmEnds ends = {};                  ///< of the arm in it
  SerialArm<double> arm;              ///< corrected, without the payload
  std::vector<double> friction = {};  ///< by joint, dry; empty: as in the file
  PointMass payload = {};             ///< in the frame of the tip
  std::vector<Carried> others = {};   ///< effects that are none of an arm's model, such as a sensor's
};

/// The user's own file, edited in place. The masses of a link are changed by one factor and one shift for all
/// bodies that move with it. The base stays; what it moves by is in the frame of the first joint.
/// \throws Error as read_arm() does, and where the arms have not the same joints
Written edited(const CorrectedArm& corrected);

}  // namespace plumbline::exchange
