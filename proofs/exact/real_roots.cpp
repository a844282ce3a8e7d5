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

}  // namespace

PositiveRoots::PositiveRoots(Polynomial p)
    : p_(trimmed(std::move(p))), sturm_(p_), end_(beyond_all_roots(p_)) {}

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
  return evaluate(p_, x) == 0 || sturm_.distinct_roots(bracket.low, x) > 0;
}

}  // namespace plumbline::proofs
