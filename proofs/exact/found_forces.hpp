#pragma once
/// \file
/// From rounded values of critical forces to bounds that exact counts prove, as far as the digits suffice.

#include <algorithm>
#include <functional>
#include <optional>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"

namespace plumbline::proofs {

/// How many critical forces lie below each of many.
using CountsBelow = std::function<std::vector<std::size_t>(const std::vector<Rational>&)>;

/// The budget of whoever computes with ever more digits: none of the numbers that a person writes takes so
/// many.
/// \throws Error beyond it
inline void require_affordable(int digits) {
  constexpr int most = 40000;
  if (digits > most)
    throw Error("critical factors", "numbers so far apart that 40000 digits do not tell them",
                "lengths, stiffnesses and loads less far apart");
}

class FoundForces {
 public:
  /// The lowest so many, each to so many significant digits.
  FoundForces(std::size_t wanted, int digits, CountsBelow below)
      : found_(wanted), digits_(digits), below_(std::move(below)) {}

  /// Encloses what is still open from the values of the forces, computed with so many digits, the last four
  /// of which rounding may have spoilt.
  template <Floating Real>
  void enclose(const std::vector<Real>& values, int working_digits) {
    std::vector<std::size_t> open;
    std::vector<Rational> ends;
    for (std::size_t i = 0; i < std::min(found_.size(), values.size()); ++i) {
      if (found_[i]) continue;
      for (int guard = 3; digits_ + guard + 4 <= working_digits; guard += 6) {
        const DecimalBounds at = bounds(values[i], digits_, guard);
        if (!at.agree && guard < 20) continue;
        open.push_back(i);
        ends.push_back(at.low);
        ends.push_back(at.high);
        break;
      }
    }
    const std::vector<std::size_t> below = below_(ends);
    for (std::size_t o = 0; o < open.size(); ++o) {
      const std::size_t index = open[o] + 1, below_low = below[2 * o], below_high = below[2 * o + 1];
      if (below_low < index && index <= below_high)
        found_[open[o]] = {index, ends[2 * o], ends[2 * o + 1], below_low, below_high};
    }
    share_ties();
  }
  [[nodiscard]] bool complete() const {
    return std::all_of(found_.begin(), found_.end(), [](const auto& one) { return one.has_value(); });
  }
  /// All of them, once they are complete.
  [[nodiscard]] std::vector<ForceEnclosure> all() const {
    std::vector<ForceEnclosure> result;
    for (const auto& one : found_) result.push_back(*one);
    return result;
  }

 private:
  /// Two units on either side of x in the digit after `kept` + `guard` significant ones, and whether the two
  /// ends round to the same decimal of `kept` digits.
  struct DecimalBounds {
    Rational low, high;
    bool agree;
  };
  template <Floating Real>
  static DecimalBounds bounds(const Real& x, int kept, int guard) {
    long exponent = 0;
    const auto digits = static_cast<std::size_t>(kept) + static_cast<std::size_t>(guard);
    char* const text = mpfr_get_str(nullptr, &exponent, 10, digits, x.backend().data(), MPFR_RNDN);
    const Integer mantissa(text), tail = mp::pow(Integer(10), static_cast<unsigned>(guard));
    mpfr_free_str(text);
    const Integer low = mantissa - 2, high = mantissa + 2;
    const auto rounded = [&](const Integer& m) { return Integer((m + tail / 2) / tail); };
    const int place = static_cast<int>(exponent) - kept - guard;
    return {shifted(low, place), shifted(high, place), rounded(low) == rounded(high)};
  }

  /// Two forces closer to each other than the digits have the bounds of the first.
  void share_ties() {
    for (std::size_t i = 1; i < found_.size(); ++i) {
      const auto& before = found_[i - 1];
      if (!before || before->below_high <= i) continue;
      found_[i] = before;
      found_[i]->index = i + 1;
    }
  }

  std::vector<std::optional<ForceEnclosure>> found_;  ///< nothing where the digits have not sufficed yet
  int digits_;
  CountsBelow below_;
};

}  // namespace plumbline::proofs
