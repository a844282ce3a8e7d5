#pragma once
/// \file
/// From the bodies and joints of a simulator's model to a planar serial chain.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/bench/nominal_chain.hpp"

namespace plumbline::exchange {

/// A joint as a simulator's model has it, in the model's reference configuration, and all that moves with it
/// before the next joint.
struct ReadJoint {
  std::string name;
  std::string carrier;  ///< name of the joint that it moves with; empty at the base
  bool hinge = true;
  Eigen::Vector3d axis, anchor;  ///< in the world
  double stiffness = 0;
  double rest = 0;  ///< how far the angle at which the spring is at ease is from that of the reference
  double mass = 0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< centre of mass, in the world
};

struct ReadModel {
  std::vector<ReadJoint> joints;
  std::optional<Eigen::Vector3d> end;  ///< a point of the last link, where the model names one
  std::string end_name;
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  std::vector<std::string> left_out;  ///< what else the model has: "frictionloss of q1"
};

struct PlanarChain {
  diagnose::NominalChain chain;
  std::vector<std::string> notes;  ///< which joints were taken, what was assumed, what was left out
};

/// \param source  named in errors
/// \throws Error, one line, that says what is not planar, not serial, or no hinge
PlanarChain planar_chain(const ReadModel& model, const std::string& source);

}  // namespace plumbline::exchange
