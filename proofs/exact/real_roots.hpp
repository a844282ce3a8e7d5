#pragma once
/// \file
/// Positive real roots of exact polynomials, isolated by Descartes' rule of signs: the changes of sign among
/// the coefficients of (1 + x)^n p((a + b x) / (1 + x)) are as many as the roots between a and b, or more by
/// an even number; where there are none or one, they are exact, and halving leads there (Vincent; Collins and
/// Akritas, Polynomial Real Root Isolation Using Descartes' Rule of Signs, 1976).

#include <optional>
#include <string>

#include "proofs/exact/polynomial.hpp"

namespace plumbline::proofs {

/// low < root < high, and no other root there; neither end is one, and low is positive.
struct RootBracket {
  Rational low, high;
};

class PositiveRoots {
 public:
  /// \throws Error for p = 0
  explicit PositiveRoots(const Polynomial& p);

  /// Ascending, each root once.
  [[nodiscard]] const std::vector<RootBracket>& all() const { return all_; }
  /// Whether the root in a bracket lies at x, which is in the bracket, or below.
  [[nodiscard]] bool reached(const RootBracket& bracket, const Rational& x) const;
  /// The root in a bracket where it is a fraction of up to twenty digits over as many; else nothing.
  [[nodiscard]] std::optional<Rational> as_fraction(const RootBracket& bracket) const;

 private:
  Polynomial p_;  ///< each root once, so that it has another sign to either side
  std::vector<RootBracket> all_;
};

/// A number in a bracket, to so many digits.
struct NarrowBracket {
  Rational low, high;   ///< half a unit of the last digit apart at most
  std::string decimal;  ///< rounded to nearest
};

/// A bracket, halved until both ends round alike, or a root half-way between two decimals is all that is
/// left. \param reached  whether what is sought lies at a number or below
template <class Reached>
NarrowBracket narrowed(RootBracket bracket, int digits, const Reached& reached);

}  // namespace plumbline::proofs
#include "proofs/exact/decimal.hpp"

namespace plumbline::proofs {

template <class Reached>
NarrowBracket narrowed(RootBracket bracket, int digits, const Reached& reached) {
  for (;;) {
    const Rational width = bracket.high - bracket.low;
    const bool narrow = bracket.low > 0 && 2 * width < unit_in_digit(bracket.low, digits);
    const std::string text = to_decimal(bracket.low, digits);
    if (narrow && (text == to_decimal(bracket.high, digits) ||
                   width < shifted(unit_in_digit(bracket.low, digits), -20)))
      return {bracket.low, bracket.high, text};
    // a short decimal near the middle: what others check stays short
    const Rational middle = (bracket.low + bracket.high) / 2;
    const auto places = static_cast<int>(mpz_sizeinbase(mpq_denref(width.backend().data()), 10));
    Rational at = *parse_decimal(to_fixed(middle, places));
    if (!(bracket.low < at && at < bracket.high)) at = middle;
    (reached(at) ? bracket.high : bracket.low) = at;
  }
}

}  // namespace plumbline::proofs
