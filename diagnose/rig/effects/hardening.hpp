#pragma once
/// \file
/// What the rows of springs that harden or soften share.

#include <algorithm>

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// Softening c that takes away all of what a spring carries at the typical deflection, 1/phi^2; such a
/// deflection may be less than the force suggests, so no less than 3.
inline double full_softening(const CharacteristicScales& sizes) {
  return std::max(3.0, 1 / (sizes.deflection * sizes.deflection));
}

/// c of k d (1 + c d^2): sizeable is half at a deflection of one radian, or a twentieth at a typical one.
inline ParameterRange hardening(const CharacteristicScales& sizes) {
  const double full = full_softening(sizes);
  return both_ways("c", "1/rad²", std::max(0.5, 0.05 * full), -full, 20 * full);
}

}  // namespace plumbline::diagnose
