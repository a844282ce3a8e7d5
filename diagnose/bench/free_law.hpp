#pragma once
/// \file
/// A free torque law of a joint.

#include <cstddef>
#include <vector>

namespace plumbline::diagnose {

/// A torque of one joint in parallel with its spring, positive where it resists a positive deflection.
struct FreeLaw {
  struct Knot {
    double deflection, torque;  ///< rad; N m
    friend bool operator==(const Knot&, const Knot&) = default;
  };
  /// A slider that starts from rest. Its slip torque is constant, or grows with the deflection (`growth`), or
  /// follows a profile.
  struct Slider {
    double slips_at;                 ///< rad, from rest at no deflection
    double torque, growth;           ///< N m; N m/rad; one of the two at most is not zero
    std::vector<Knot> profile = {};  ///< slip torques; the slider carries the same fraction of each
    friend bool operator==(const Slider&, const Slider&) = default;
  };
  /// A Maxwell arm.
  struct Arm {
    double time_constant, stiffness;  ///< s; N m/rad
    friend bool operator==(const Arm&, const Arm&) = default;
  };

  std::size_t joint;        ///< from 1
  std::vector<Knot> knots;  ///< by deflection; straight between them and on beyond them
  std::vector<Slider> sliders = {};
  std::vector<Arm> arms = {};
  friend bool operator==(const FreeLaw&, const FreeLaw&) = default;
};

}  // namespace plumbline::diagnose
