#include "proofs/exact/real_roots.hpp"

#include <algorithm>

namespace plumbline::proofs {
namespace {

/// Cauchy's bound, rounded up to a power of two.
Rational beyond_all_roots(const Polynomial& p) {
  Rational largest = 0;
  for (const Rational& c : p) largest = std::max(largest, Rational(abs(Rational(c / p.back()))));
  Rational power = 1;
  while (power <= largest + 1) power *= 2;
  return power;
}

/// The fraction of the smallest denominator between two positive numbers, by their continued fractions.
Rational simplest_between(const Rational& low, const Rational& high) {
  const Integer whole = mp::numerator(low) / mp::denominator(low);
  if (Rational(whole) + 1 < high) return Rational(whole) + 1;
  const Rational rest_low = low - whole, rest_high = high - whole;
  if (rest_low == 0)
    return whole +
           1 / (Rational(mp::numerator(Rational(1 / rest_high)) / mp::denominator(Rational(1 / rest_high))) +
                1);
  return whole + 1 / simplest_between(Rational(1 / rest_high), Rational(1 / rest_low));
}

}  // namespace

PositiveRoots::PositiveRoots(Polynomial p)
    : p_(squarefree(trimmed(std::move(p)))), sturm_(p_), end_(beyond_all_roots(p_)) {}

std::optional<RootBracket> PositiveRoots::next(const Rational& from) const {
  RootBracket bracket{from, end_};
  if (sturm_.distinct_roots(from, end_) == 0) return std::nullopt;
  while (sturm_.distinct_roots(bracket.low, bracket.high) > 1 || bracket.low == 0) {
    Rational middle = (bracket.low + bracket.high) / 2;
    while (evaluate(p_, middle) == 0) middle = (bracket.low + 2 * middle) / 3;
    (sturm_.distinct_roots(bracket.low, middle) > 0 ? bracket.high : bracket.low) = middle;
  }
  return bracket;
}

bool PositiveRoots::reached(const RootBracket& bracket, const Rational& x) const {
  return evaluate(p_, bracket.low).sign() * evaluate(p_, x).sign() <= 0;
}

std::optional<Rational> PositiveRoots::as_fraction(const RootBracket& bracket) const {
  constexpr int enough = 41;  // two fractions of twenty digits are farther apart
  const NarrowBracket near =
      narrowed(bracket, enough, [&](const Rational& x) { return reached(bracket, x); });
  if (evaluate(p_, near.high) == 0) return near.high;
  const Rational simplest = simplest_between(near.low, near.high);
  return evaluate(p_, simplest) == 0 ? std::optional(simplest) : std::nullopt;
}

}  // namespace plumbline::proofs
