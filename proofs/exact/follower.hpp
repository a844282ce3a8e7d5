#pragma once
/// \file
/// Where a straight structure under loads without an energy loses its stability, and where it gains it again:
/// exact counts of the real roots of the characteristic polynomial, no eigenvalue in floating point.
///
/// M w'' + (K - factor A) w = 0 stays small where all squares of its circular frequencies are positive and
/// there are as many independent shapes as unknowns. Frequencies change from one kind to another at the roots
/// of det(K - factor A), where one is zero, and of the discriminant of the characteristic polynomial, where
/// two are equal. Between two roots next to each other nothing changes, so that one factor there speaks for
/// all; at the roots themselves the motion is looked at anew.

#include <plumbline/straight/motion.hpp>
#include <string>

#include "proofs/exact/polynomial.hpp"

namespace plumbline::proofs {

/// What the small motion about the straight line does at a factor.
enum class Motion {
  stable,      ///< it swings
  divergence,  ///< a frequency is zero, or it grows without swinging
  flutter,     ///< it swings ever wider
  undecided    ///< two frequencies are equal, and whether they share one shape, which grows, is open
};

/// "stable", "divergence", "flutter" or "undecided".
const char* name_of(Motion motion);

/// The polynomial det(K - factor A - x M) in x, the square of the circular frequency.
Polynomial characteristic_polynomial(const StraightMotion<Rational>& motion, const Rational& factor);
/// By the roots of that polynomial, counted by Sturm's theorem; never undecided.
Motion motion_at(const StraightMotion<Rational>& motion, const Rational& factor);

/// A factor at which the motion changes, or is another than on either side.
struct MotionChange {
  Rational low, high;  ///< around it, to the digits that were asked for
  std::string factor;  ///< as a decimal, rounded to nearest
  Motion at;           ///< there
  Motion above;        ///< from there to the next change
};

/// The first loss of stability.
struct StabilityLoss {
  Motion kind;         ///< what sets in: at the factor itself where it is stable again just above
  Rational low, high;  ///< around the factor at which it does, to the digits that were asked for
  std::string factor;  ///< as a decimal, rounded to nearest
  /// Whether it is proved that the line is stable at every factor below, but for those in `changes` before
  /// it.
  bool first;
  /// Where the motion changes, ascending, the loss among them: at these factors alone, at whatever factor
  /// there is. Empty where they were not all found.
  std::vector<MotionChange> changes;
};

/// Up to so many unknowns the motion is known at every factor, from all roots of det(K - factor A) and of the
/// discriminant, as polynomials in the factor; beyond, factors are tried in steps of a fraction of what would
/// be critical if the forces were dead, and a loss between two of them that is made good again is not seen.
inline constexpr Eigen::Index most_for_discriminant = 8;

/// The first loss of stability as the factor grows from zero, to so many significant digits.
/// \throws Error where the line is not stable at zero, and where it is never lost, or, beyond so many
///         unknowns, not found to be; and where two frequencies are equal at every factor under a load that
///         is not symmetric
StabilityLoss stability_loss(const StraightMotion<Rational>& motion, int digits);

}  // namespace plumbline::proofs
