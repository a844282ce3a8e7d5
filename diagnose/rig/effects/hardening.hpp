#pragma once
/// \file
/// Ranges of the hardening parameter.

#include <algorithm>

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// The softening c at which a spring carries nothing at the typical deflection phi: 1/phi^2, and at least 3,
/// for actual deflections may be smaller than the force suggests.
inline double full_softening(const CharacteristicScales& sizes) {
  return std::max(3.0, 1 / (sizes.deflection * sizes.deflection));
}

/// c of k d (1 + c d^2). Its scale is 0.5, or 5 % of the torque at a typical deflection, whichever is larger.
inline ParameterRange hardening(const CharacteristicScales& sizes) {
  const double full = full_softening(sizes);
  return both_ways("c", "1/rad²", std::max(0.5, 0.05 * full), -full, 20 * full);
}

}  // namespace plumbline::diagnose
