#pragma once
/// \file
/// What a joint carries where no known effect says why.

#include <cstddef>
#include <vector>

namespace plumbline::diagnose {

/// Torques of one joint beside those of its spring, in the sense of a spring: positive resists a positive
/// deflection.
struct FreeLaw {
  struct Knot {
    double deflection, torque;  ///< rad; N m
    friend bool operator==(const Knot&, const Knot&) = default;
  };
  /// A spring that slips, from rest after a turn: at a torque; or, where `growth` is given, at one that grows
  /// with the deflection; or, where a profile is, at one that goes with it from knot to knot.
  struct Slider {
    double slips_at;                 ///< rad, from rest at no deflection
    double torque, growth;           ///< N m; N m/rad; one of the two at most is not zero
    std::vector<Knot> profile = {};  ///< torques at which it slips; it carries the same share of each
    friend bool operator==(const Slider&, const Slider&) = default;
  };
  /// A spring that relaxes.
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
