#pragma once
/// \file
/// Where a straight structure under loads without an energy loses its stability: exact counts of the real
/// roots of the characteristic polynomial, no eigenvalue in floating point.

#include <plumbline/straight/motion.hpp>
#include <string>

#include "proofs/exact/polynomial.hpp"

namespace plumbline::proofs {

/// What the small motion about the straight line does at a factor.
enum class Motion {
  stable,      ///< it swings, at as many frequencies as there are unknowns
  divergence,  ///< it grows without swinging
  flutter      ///< it swings ever wider; or two frequencies are equal
};

/// The polynomial det(K - factor A - x M) in x, the square of the circular frequency.
Polynomial characteristic_polynomial(const StraightMotion<Rational>& motion, const Rational& factor);
/// By the roots of that polynomial, counted by Sturm's theorem.
Motion motion_at(const StraightMotion<Rational>& motion, const Rational& factor);

/// The loss of stability: stable at low, not at high.
struct StabilityLoss {
  Motion kind;         ///< what sets in
  Rational low, high;  ///< around the factor at which it does, to the digits that were asked for
  std::string factor;  ///< as a decimal, rounded to nearest
  bool first;          ///< whether it is proved that the line is stable at every factor below
};

/// Up to so many unknowns the first loss is found among all roots of det(K - factor A) and of the
/// discriminant, as polynomials in the factor; beyond, among factors in steps of a fraction of what would be
/// critical if the forces were dead.
inline constexpr Eigen::Index most_for_discriminant = 8;

/// The first loss of stability as the factor grows from zero, to so many significant digits.
/// \throws Error where the line is not stable at zero, and where it is never lost, or, beyond so many
///         unknowns, not found to be
StabilityLoss stability_loss(const StraightMotion<Rational>& motion, int digits);

}  // namespace plumbline::proofs
