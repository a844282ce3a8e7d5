#pragma once
/// \file
/// A simulator's model, independent of its format: joints, springs, masses, gravity.

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "diagnose/exchange/catalogue_rows.hpp"

namespace plumbline::exchange {

/// `free`: of a body that is held by nothing; `other`: more than one coordinate, or coupled ones.
enum class JointMotion { hinge, slide, free, other };

/// A joint as a simulator's model has it, in the model's reference configuration, and all that moves with it
/// before the next joint.
struct ReadJoint {
  std::string name;
  std::string carrier;  ///< name of the joint that it moves with; empty at the base
  JointMotion motion = JointMotion::hinge;
  std::string type = {};                               ///< the format's word for the motion
  Eigen::Vector3d axis, anchor;                        ///< in the world
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  ///< of the body that it moves, in the world
  double stiffness = 0;
  double rest = 0;       ///< how far the coordinate at which the spring is at ease is from the reference's
  double servo = 0;      ///< the part of the stiffness by which a servo holds its command
  double reference = 0;  ///< its coordinate in the reference configuration
  std::array<double, 2> range{-std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};  ///< of the coordinate
  double friction = 0;       ///< torque or force at which it slips
  std::string follows = {};  ///< another joint, or constant, to which the model couples it
  double mass = 0;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< centre of mass, in the world

  [[nodiscard]] bool bounded() const { return range[1] - range[0] < std::numeric_limits<double>::infinity(); }
};

/// Adds what weighs to what a joint moves.
void add_mass(ReadJoint& joint, double mass, const Eigen::Vector3d& middle);

/// A body with moments of inertia, which statics does not use.
struct ReadInertia {
  std::string body;
  std::string carrier;  ///< name of the joint that it moves with
  double mass;
  Eigen::Vector3d middle;  ///< centre of mass
  Eigen::Matrix3d tensor;  ///< about it, kg m^2; zero where the file does not say
};

/// A point that a model names.
struct ReadPoint {
  std::string kind, name;  ///< "site", "tool_tip"
  std::string carrier;     ///< name of the joint that it moves with; empty at the base
  Eigen::Vector3d place;   ///< in the world
  std::size_t number = 0;  ///< among those of its kind
};

/// A body, or a frame on one.
struct ReadFrame {
  std::string kind, name;  ///< "link", "upper_arm"
  std::string carrier;     ///< name of the joint that it moves with; empty at the base
  std::string on;          ///< the body that carries it; empty for a root
  Eigen::Isometry3d at;    ///< in the world

  /// Whether others may hang on it.
  [[nodiscard]] bool is_body() const { return kind == "link" || kind == "body"; }
};

/// A constraint between two bodies of a tree.
struct ReadLoop {
  std::string name;
  std::array<std::string, 2> carriers;  ///< names of the joints that the bodies move with
};

struct ReadModel {
  std::vector<ReadJoint> joints;  ///< each name once
  std::vector<ReadPoint> ends;    ///< what may be the end point of a chain in the plane
  std::vector<ReadFrame> frames;  ///< all, a body before what it carries
  std::vector<ReadLoop> loops;
  std::vector<ReadInertia> inertias;  ///< of the bodies that weigh
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  /// Where the model stands: everything in it is said in a frame that has this pose in the world.
  Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
  CatalogueRows rows;                 ///< corrections that are in it
  std::vector<std::string> notes;     ///< what was assumed
  std::vector<std::string> left_out;  ///< what else the model has: "2 tendons"
};

/// Without the joints and bodies that its rows added, which say the same.
void drop_added(ReadModel& model);

}  // namespace plumbline::exchange
