#pragma once
/// \file
/// A chain as simulators of bodies have it: a tree of bodies and hinges in the plane, and what couples them.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

using Pair = std::array<double, 2>;

/// A hinge about z, or a slide along x or y.
struct Hinge {
  std::string name;
  char along = 'z';  ///< 'z': hinge; 'x', 'y': slide
  double stiffness = 0, rest = 0;
  double friction = 0;  ///< torque at which it slips
  double damping = 0, armature = 0;
  std::optional<Pair> range = {};
  double range_stiffness = 0;  ///< beyond the range; 0: hard
};

/// Moves by its joint against the body that carries it.
struct Body {
  std::string name, parent;  ///< of the world: no parent
  Pair place{0, 0};          ///< in the frame of the parent
  double mass = 0;
  Pair middle{0, 0};  ///< centre of mass
  double length = 0;  ///< to be drawn; 0 where it is a point
  std::optional<Hinge> joint = {};
  double turning = 1e-6;  ///< moment of inertia, kg m², in formats whose joints have no armature
};

/// Along or about which it moves, in its own frame.
inline Eigen::Vector3d direction_of(const Body& one) {
  const char along = one.joint ? one.joint->along : 'z';
  return {along == 'x' ? 1.0 : 0.0, along == 'y' ? 1.0 : 0.0, along == 'z' ? 1.0 : 0.0};
}

/// A spring on a weighted sum of joints, at ease in the unloaded shape.
struct Tendon {
  std::string name;
  std::vector<std::pair<std::string, double>> joints;
  double stiffness = 0, friction = 0;
};

/// A torque on a weighted sum of joints that goes steadily from none at `from` to `torque` at `to`, and stays
/// at either end. Ramps add up to any law that is piecewise linear.
struct Ramp {
  std::string name;
  std::vector<std::pair<std::string, double>> joints;
  double from, to, torque;
};

/// The bench's drive and its load cell: a rail, turned by an angle about a point, along which the drive leads
/// the cell, which holds the end point.
struct Drive {
  Pair start{0, 0};     ///< the point about which the rail is turned
  double turned = 0;    ///< rad
  double friction = 0;  ///< N, along the rail's x
  double stiffness;     ///< of drive and cell, N/m: as good as rigid
  /// The cell reads matrix · force + bias + drift · time, row by row.
  std::array<double, 4> matrix{1, 0, 0, 1};
  Pair bias{0, 0}, drift{0, 0};
  double limit = 0;  ///< largest reading; 0 without one
  double lag = 0;    ///< time constant, s
};

/// A slide, under a constant force, that goes with a power of a hinge's deflection.
struct Follower {
  std::string slide, hinge;
  int power;    ///< 2 or 4
  double rest;  ///< of the hinge
  double force;
};

struct Tree {
  Pair gravity{0, 0};
  std::vector<Body> bodies;  ///< parents first
  std::vector<Tendon> tendons;
  std::vector<Follower> followers;
  std::vector<Ramp> ramps;
  std::optional<Drive> drive;  ///< where something of the rig is the drive's or the cell's
  std::string tip;             ///< the body of the last link
  Pair end{0, 0}, load{0, 0};  ///< the end point, and where forces act on it, in its frame
};

/// What a format has besides bodies and joints.
struct Means {
  bool tendons = false;      ///< and followers, ramps, drives
  bool soft_ranges = false;  ///< a range that yields by a stiffness
};

/// Whether anything of the rig is the drive's or the load cell's.
bool has_drive(const diagnose::Rig& rig);

/// The tree of a rig whose effects the format can carry.
/// \param down  of gravity where nothing in the rig weighs
Tree tree_of(const diagnose::Rig& rig, const Model& model, const Means& means);

/// kg: of a body that weighs nothing; sdformat drops what has a millionth or less.
inline constexpr double speck = 1e-5;

/// How fast joints settle, s: dynamics of the written model, of which statics knows nothing.
inline constexpr double response_time = 0.02;

}  // namespace plumbline::exchange
