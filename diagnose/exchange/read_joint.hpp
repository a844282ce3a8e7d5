#pragma once
/// \file
/// A simulator's model, independent of its format: joints, springs, masses, gravity.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace plumbline::exchange {

/// A joint as a simulator's model has it, in the model's reference configuration, and all that moves with it
/// before the next joint.
struct ReadJoint {
  std::string name;
  std::string carrier;  ///< name of the joint that it moves with; empty at the base
  bool hinge = true;
  bool free = false;             ///< of a body that is held by nothing
  Eigen::Vector3d axis, anchor;  ///< in the world
  double stiffness = 0;
  double rest = 0;  ///< how far the angle at which the spring is at ease is from that of the reference
  double mass = 0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< centre of mass, in the world
};

/// Adds what weighs to what a joint moves.
void add_mass(ReadJoint& joint, double mass, const Eigen::Vector3d& middle);

/// A point that a model names.
struct ReadPoint {
  std::string kind, name;  ///< "site", "tool_tip"
  std::string carrier;     ///< name of the joint that it moves with; empty at the base
  Eigen::Vector3d place;   ///< in the world
  std::size_t number = 0;  ///< among those of its kind
};

struct ReadModel {
  std::vector<ReadJoint> joints;  ///< each name once
  std::vector<ReadPoint> ends;    ///< what may be the end point
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  std::vector<std::string> notes;     ///< what was assumed
  std::vector<std::string> left_out;  ///< what else the model has: "frictionloss of q1"
};

}  // namespace plumbline::exchange
