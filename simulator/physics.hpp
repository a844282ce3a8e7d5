#pragma once
/// \file
/// The rig as it really is. As `physics_of(plan)` makes it, it is what the lab believes; an effect changes
/// some of it.

#include <limits>
#include <vector>

#include "simulator/plan.hpp"

namespace plumbline::simulator {

/// Standard gravity as the effect catalogue counts it, m/s^2.
inline constexpr double standard_gravity = 9.81;

struct Joint {
  double stiffness = 0, rest_error = 0;
  double backlash = 0;
  double stop = std::numeric_limits<double>::infinity(), stop_stiffness = 0;
  double friction = 0;      ///< torque at which it slips
  double hardening = 0;     ///< c of k d (1 + c d^2)
  double detent = 0;        ///< amplitude of a ripple A sin(w d)
  double detent_waves = 0;  ///< w
  double softening = 0;     ///< stiffness lost per radian of the largest deflection so far
};

/// A spring between the base pivot and the axis of a joint; slack in the unloaded shape.
struct Band {
  std::size_t joint = 0;  ///< counted from 0; 0 is none
  double stiffness = 0;
};

/// A magnet beside the path that pulls the end point: strength * r exp(-r^2 / 2 width^2).
struct Magnet {
  Pair place{0, 0};
  double strength = 0, width = 1;
};

/// A sine in time or along the way.
struct Wave {
  Pair amplitude{0, 0};
  double period = 1;
};

struct Physics {
  std::vector<Joint> joint;
  std::vector<double> length, mass;
  double coupling = 0, axial = 0, flexibility = 0;  ///< kappa, c_a, 1/EI
  double arm_ratio = 0, relaxation = 1;             ///< Maxwell arms: m, tau
  double tip_stiffness = 0, eccentricity = 0;
  double tip_mass = 0;
  double pivot_friction = 0;  ///< dry friction of the end pivot
  Band band;
  Pair base_compliance{0, 0};
  double train_compliance = 0;
  // The carriage.
  double misalignment = 0;
  Pair position_offset{0, 0};
  Wave screw;  ///< pitch error of the drive: x goes astray by a sine of the way
  Magnet magnet;
  // The load cell and the drive.
  double guide_friction = 0, gain = 0;
  Pair bias{0, 0}, drift{0, 0};
  Wave zero;  ///< of the load cell, with the temperature of the room
};

inline Physics physics_of(const Plan& plan) {
  Physics is;
  is.length = plan.nominal.length;
  is.mass = plan.nominal.mass;
  is.mass.resize(plan.size(), 0.0);
  for (const double k : plan.nominal.stiffness) is.joint.push_back({.stiffness = k});
  return is;
}

}  // namespace plumbline::simulator
