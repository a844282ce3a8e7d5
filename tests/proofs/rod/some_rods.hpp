#pragma once
// Rods of unit stiffness and length for the tests.

#include "proofs/rod/critical_rod.hpp"

namespace plumbline::proofs {

inline Support<Rational> clamped_base() {
  return {Restraint<Rational>::held(), Restraint<Rational>::held(), Restraint<Rational>::held()};
}

/// Without loads.
inline Rod bare_rod(Support<Rational> base, Support<Rational> end_point) {
  Rod rod;
  rod.base = std::move(base);
  rod.end_point = std::move(end_point);
  return rod;
}

/// Under a dead force at the end point.
inline Rod compressed_rod(Support<Rational> base, Support<Rational> end_point) {
  Rod rod = bare_rod(std::move(base), std::move(end_point));
  rod.loads = {{rod.length, 1}};
  return rod;
}

/// Clamped below, free above, with its own weight.
inline Rod heavy_rod(Support<Rational> base, Support<Rational> end_point) {
  Rod rod = bare_rod(std::move(base), std::move(end_point));
  rod.weights = {{0, 1, 1}};
  return rod;
}

/// Beck's column.
inline Rod beck_rod() {
  Rod rod = bare_rod(clamped_base(), {});
  rod.loads = {{1, 1, true, LoadKind::follower}};
  return rod;
}

}  // namespace plumbline::proofs
