#pragma once
/// \file
/// What holds a chain: the ends of it and any joint.

#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>
#include <string>

namespace plumbline {

/// How one motion of one place is restrained.
enum class Hold {
  free,    ///< not at all
  sprung,  ///< by a linear spring to the ground
  held     ///< it is zero
};

/// One motion of one place.
template <Number Real>
struct Restraint {
  Hold hold = Hold::free;  ///< how it is restrained
  Real stiffness{0};       ///< of the spring, where there is one

  /// The motion is zero.
  static Restraint held() { return {Hold::held, Real(0)}; }
  /// A stiffness of zero is no spring.
  static Restraint sprung(Real stiffness) { return {Hold::sprung, std::move(stiffness)}; }
  /// One more spring beside it, which nothing that is held feels.
  void add(const Real& spring) {
    if (is_held()) return;
    hold = Hold::sprung;
    stiffness = stiffness + spring;
  }
  /// Whether it costs nothing.
  [[nodiscard]] bool is_free() const {
    return hold == Hold::free || (hold == Hold::sprung && stiffness == Real(0));
  }
  /// Whether the motion is zero.
  [[nodiscard]] bool is_held() const { return hold == Hold::held; }
};

/// What holds an end: along the straight chain, across it, and against turning with the link that ends there.
template <Number Real>
struct Support {
  Restraint<Real> along;   ///< along the straight chain
  Restraint<Real> across;  ///< across it
  Restraint<Real> turn;    ///< against turning with the link that ends there
};

/// The base as in the paper: it does not move, and the spring of joint 1 alone holds the direction of link 1.
template <Number Real>
Support<Real> pinned() {
  return {Restraint<Real>::held(), Restraint<Real>::held(), {}};
}
/// The end point as in the paper: led along the line.
template <Number Real>
Support<Real> guided() {
  return {{}, Restraint<Real>::held(), {}};
}
/// Led along the line, its link's direction held.
template <Number Real>
Support<Real> clamped() {
  return {{}, Restraint<Real>::held(), Restraint<Real>::held()};
}

}  // namespace plumbline
