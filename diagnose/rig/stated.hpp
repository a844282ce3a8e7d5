#pragma once
/// \file
/// User effects as expressions: torques in parallel with the springs, and corrections of readings.
/// docs/user-effects.md

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "diagnose/bench/channel.hpp"
#include "diagnose/rig/formula.hpp"

namespace plumbline::diagnose {

struct Torque;

/// The variables of a torque: joint angle, deflection from rest, direction of motion, time of the reading,
/// the joint's stiffness, true force on the end point, of which a plane has no z. The covariates of the
/// experiment follow, then the parameters.
inline constexpr std::array<const char*, 8> torque_variables{"q", "d", "s", "t", "k", "Fx", "Fy", "Fz"};

/// A torque of one joint, N m: positive where it resists a positive deflection, as k d does.
struct StatedTorque {
  std::size_t joint;  ///< from 0
  std::shared_ptr<const Formula> formula;
  std::vector<double> parameters;
  friend bool operator==(const StatedTorque&, const StatedTorque&) = default;

  /// The values of the variables at a joint.
  struct Place {
    double q, d, t, k;
    Eigen::Vector3d force;
    std::span<const double> covariates = {};
  };
  [[nodiscard]] bool directed() const { return formula->uses("s"); }
  /// \param motion  direction of the joint's motion: 1 or -1, or a value between them while the joint sticks,
  ///                where the torque is interpolated between the two directions
  [[nodiscard]] double value(const Place& at, double motion) const;
  /// Its derivatives by the joint angle and, in the plane, by the force.
  [[nodiscard]] double slope(const Place& at, const Torque& motion) const;
  [[nodiscard]] Eigen::Vector2d by_force(const Place& at, double motion) const;

 private:
  [[nodiscard]] double towards(const Place& at, double direction) const;
};

/// The variables of a correction: the readings without it, time, number of the run (from 1), direction of
/// motion. The variables of an angle follow, then the covariates, then the parameters.
inline constexpr std::array<const char*, 7> reading_variables{"x", "y", "Fx", "Fy", "t", "run", "s"};

/// Further variables of a joint angle: the angle itself, and its deflection.
inline constexpr std::array<const char*, 2> angle_variables{"q", "d"};

/// A correction that is added to the readings of a measured channel.
struct StatedCorrection {
  Channel::Name channel;
  std::optional<std::size_t> joint;  ///< of q, from 0; nullopt: the angles of all joints
  std::shared_ptr<const Formula> formula;
  std::vector<double> parameters;
  friend bool operator==(const StatedCorrection&, const StatedCorrection&) = default;

  [[nodiscard]] bool applies_to(const Channel& other) const {
    return other.name == channel && (!joint || *joint == other.joint);
  }
  /// \param values  of the variables of its channel
  [[nodiscard]] double value(std::span<const double> values) const { return formula->at(values, parameters); }
};

}  // namespace plumbline::diagnose
