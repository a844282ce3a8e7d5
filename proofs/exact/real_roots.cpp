#include "proofs/exact/real_roots.hpp"

#include <algorithm>

namespace plumbline::proofs {
namespace {

using Integers = std::vector<Integer>;

/// A positive multiple with whole coefficients.
Integers whole(const Polynomial& p) {
  Integer scale = 1;
  for (const Rational& c : p) scale = mp::lcm(scale, mp::denominator(c));
  Integers result;
  for (const Rational& c : p) result.push_back(mp::numerator(Rational(c * scale)));
  return result;
}

/// p(x) becomes p(x + by).
void shift(Integers& p, const Integer& by) {
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    for (std::size_t j = p.size() - 1; j-- > i;) p[j] += by * p[j + 1];
  }
}

/// The changes of sign of (1 + x)^n p((low + high x) / (1 + x)).
std::size_t variations(Integers p, const Rational& low, const Rational& high) {
  const Integer D = mp::lcm(mp::denominator(low), mp::denominator(high));
  const Integer from = mp::numerator(Rational(low * D)), width = mp::numerator(Rational((high - low) * D));
  Integer power = 1;
  for (std::size_t i = p.size(); i-- > 0; power *= D) p[i] *= power;
  shift(p, from);
  power = 1;
  for (Integer& c : p) c *= power, power *= width;
  std::reverse(p.begin(), p.end());
  shift(p, 1);
  std::size_t changes = 0;
  int last = 0;
  for (const Integer& c : p) {
    changes += c.sign() * last < 0 ? 1 : 0;
    if (c.sign() != 0) last = c.sign();
  }
  return changes;
}

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
  const Integer whole_part = mp::numerator(low) / mp::denominator(low);
  if (Rational(whole_part) + 1 < high) return Rational(whole_part) + 1;
  const Rational rest_low = low - whole_part, per_high = 1 / Rational(high - whole_part);
  if (rest_low == 0)
    return whole_part + 1 / Rational(Rational(mp::numerator(per_high) / mp::denominator(per_high)) + 1);
  return whole_part + 1 / simplest_between(per_high, Rational(1 / rest_low));
}

}  // namespace

PositiveRoots::PositiveRoots(const Polynomial& p) : p_(squarefree(trimmed(p))) {
  const Integers integers = whole(p_);
  std::vector<RootBracket> open{{0, beyond_all_roots(p_)}};
  while (!open.empty()) {
    const RootBracket part = std::move(open.back());
    open.pop_back();
    const std::size_t most = variations(integers, part.low, part.high);
    if (most == 1 && part.low > 0) all_.push_back(part);
    if (most == 0 || (most == 1 && part.low > 0)) continue;
    Rational middle = (part.low + part.high) / 2;
    while (evaluate(p_, middle) == 0) middle = (part.low + 2 * middle) / 3;
    open.push_back({middle, part.high});
    open.push_back({part.low, middle});  // the lower part first: ascending
  }
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
