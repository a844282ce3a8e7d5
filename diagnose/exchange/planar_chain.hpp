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
  int end_site = -1;  ///< its number, where the model has sites
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  std::vector<std::string> left_out;  ///< what else the model has: "frictionloss of q1"
};

/// Whether a site, frame or link of this name is an end point.
bool names_an_end(const std::string& name);

/// The plane of a chain: x and y such that angles count about x × y. In a vertical plane y is upward.
struct Plane {
  Eigen::Vector3d x{1, 0, 0}, y{0, 1, 0}, origin{0, 0, 0};
  [[nodiscard]] Eigen::Vector3d normal() const;
  [[nodiscard]] Eigen::Vector2d of(const Eigen::Vector3d& vector) const {
    return {x.dot(vector), y.dot(vector)};
  }
};

/// A joint of the model that became one of the chain.
struct TakenJoint {
  std::size_t number;  ///< among those of the model
  double sense;        ///< -1 where it turns the other way
};

struct PlanarChain {
  diagnose::NominalChain chain;
  std::vector<std::string> notes;  ///< which joints were taken, what was assumed, what was left out
  Plane plane = {};
  std::vector<TakenJoint> joints = {};  ///< from the base on
};

/// \param source  named in errors
/// \throws Error, one line, that says what is not planar, not serial, or no hinge
PlanarChain planar_chain(const ReadModel& model, const std::string& source);

}  // namespace plumbline::exchange
