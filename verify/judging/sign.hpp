#pragma once
/// \file
/// Certified signs and zeros of a function of one variable, by subdivision.

#include <optional>
#include <plumbline/base/interval.hpp>
#include <vector>

namespace plumbline::verify {

/// '+' or '-' where x certainly has this sign, otherwise '0'.
inline char sign_character(const Interval& x) {
  return certainly_positive(x) ? '+' : certainly_negative(x) ? '-' : '0';
}

/// The sign (+1 or -1) that f certainly has on all of [low, high]; nothing where it changes or cannot be
/// decided with pieces of width (high - low) / 2^depth.
template <class Function>
std::optional<int> certain_sign(const Function& f, const Interval& low, const Interval& high,
                                int depth = 14) {
  const Interval range = f(hull(low, high));
  if (certainly_positive(range)) return 1;
  if (certainly_negative(range)) return -1;
  if (depth == 0) return std::nullopt;
  const Interval middle = (low + high) / Interval(2);
  const std::optional<int> left = certain_sign(f, low, middle, depth - 1);
  if (!left || left != certain_sign(f, middle, high, depth - 1)) return std::nullopt;
  return left;
}

/// What is certain of a function's sign on a range.
enum class SignOnRange { positive, negative, both, undecided };

/// Certain enclosures of f on pieces of [low, high] and at their middles: both signs where each is certain
/// somewhere, undecided where a piece of width (high - low) / 2^depth has no certain one.
template <class Function>
SignOnRange sign_on(const Function& f, const Interval& low, const Interval& high, int depth = 14) {
  bool positive = false, negative = false, open = false;
  const auto look = [&](const Interval& value) {
    positive = positive || certainly_positive(value);
    negative = negative || certainly_negative(value);
    return !certainly_positive(value) && !certainly_negative(value);
  };
  const auto visit = [&](const auto& self, const Interval& from, const Interval& to, int left) -> void {
    if ((positive && negative) || !look(f(hull(from, to)))) return;
    const Interval middle = (from + to) / Interval(2);
    look(f(middle));
    if (left == 0) {
      open = true;
      return;
    }
    self(self, from, middle, left - 1);
    self(self, middle, to, left - 1);
  };
  visit(visit, low, high, depth);
  if (positive && negative) return SignOnRange::both;
  if (open) return SignOnRange::undecided;
  return positive ? SignOnRange::positive : SignOnRange::negative;
}

/// Pieces of [low, high] that hold exactly one zero of f each, in ascending order; certainly there is none
/// elsewhere. A piece counts where f changes sign and its derivative df has one sign.
/// \throws Error where the
/// depth does not do.
template <class Function, class Derivative>
std::vector<Interval> isolate_zeros(const Function& f, const Derivative& df, const Interval& low,
                                    const Interval& high, int depth = 30) {
  const Interval piece = hull(low, high);
  const Interval range = f(piece);
  if (!range.contains_zero()) return {};
  if (!df(piece).contains_zero()) {
    const Interval at_low = f(low);
    const Interval at_high = f(high);
    const bool decided = !at_low.contains_zero() && !at_high.contains_zero();
    if (decided)
      return certainly_negative(at_low * at_high) ? std::vector<Interval>{piece} : std::vector<Interval>{};
  }
  if (depth == 0)
    throw Error("zeros", "an undecided piece " + piece.text(6), "simple zeros away from its ends");
  // not halfway: a zero at a round number would be a common end of two pieces
  const Interval middle = low + (high - low) * Interval(Rational(61, 127));
  std::vector<Interval> zeros = isolate_zeros(f, df, low, middle, depth - 1);
  const std::vector<Interval> right = isolate_zeros(f, df, middle, high, depth - 1);
  zeros.insert(zeros.end(), right.begin(), right.end());
  return zeros;
}

}  // namespace plumbline::verify
