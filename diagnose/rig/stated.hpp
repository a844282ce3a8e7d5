#pragma once
/// \file
/// What a user states of a rig in expressions: torques that joints carry beside their springs, and
/// corrections of readings. docs/user-effects.md

#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "diagnose/bench/channel.hpp"
#include "diagnose/rig/formula.hpp"

namespace plumbline::diagnose {

struct Torque;

/// The variables of a torque: joint angle, deflection from rest, direction of motion, time of the reading,
/// the joint's stiffness, true force on the end point. Parameters follow.
inline constexpr std::array<const char*, 7> torque_variables{"q", "d", "s", "t", "k", "Fx", "Fy"};

/// A torque that one joint carries, N m: positive against a positive deflection, as k d is.
struct StatedTorque {
  std::size_t joint;  ///< from 0
  std::shared_ptr<const Formula> formula;
  std::vector<double> parameters;
  friend bool operator==(const StatedTorque&, const StatedTorque&) = default;

  /// Where a joint stands when it is asked what it carries.
  struct Place {
    double q, d, t, k;
    Eigen::Vector2d force;
  };
  [[nodiscard]] bool directed() const { return formula->uses("s"); }
  /// \param motion  the sign of the joint's motion, between -1 and 1 where it sticks, and its slope: the
  ///                torque is then between those of the two directions
  [[nodiscard]] double value(const Place& at, double motion) const;
  /// Its derivatives by the joint angle and by the force.
  [[nodiscard]] double slope(const Place& at, const Torque& motion) const;
  [[nodiscard]] Eigen::Vector2d by_force(const Place& at, double motion) const;

 private:
  [[nodiscard]] double towards(const Place& at, double direction) const;
};

/// The variables of a correction: what the channels would read without it, time and number (from 1) of the
/// run, direction of motion. Those of an angle alone come next, then parameters.
inline constexpr std::array<const char*, 7> reading_variables{"x", "y", "Fx", "Fy", "t", "run", "s"};

/// Of a joint's angle besides: the angle itself, deflection from rest.
inline constexpr std::array<const char*, 2> angle_variables{"q", "d"};

/// What is added to the readings of a channel that is measured.
struct StatedCorrection {
  Channel::Name channel;
  std::optional<std::size_t> joint;  ///< of q, from 0; nothing: every joint's angle
  std::shared_ptr<const Formula> formula;
  std::vector<double> parameters;
  friend bool operator==(const StatedCorrection&, const StatedCorrection&) = default;

  [[nodiscard]] bool applies_to(const Channel& other) const {
    return other.name == channel && (!joint || *joint == other.joint);
  }
  /// \param values  of the variables that its channel has
  [[nodiscard]] double value(std::span<const double> values) const { return formula->at(values, parameters); }
};

}  // namespace plumbline::diagnose
