#include "proofs/enclosure.hpp"

#include <algorithm>
#include <plumbline/straight/critical_force.hpp>
#include <string>

#include "proofs/decimal.hpp"
#include "proofs/exact_count.hpp"
#include "proofs/working_precision.hpp"

namespace plumbline::proofs {
namespace {

/// Two units on either side of x in the digit after `kept` + `guard` significant ones, and whether the two
/// ends round to the same decimal of `kept` digits.
struct Bounds {
  Rational low, high;
  bool agree;
};
template <Floating Real>
Bounds bounds(const Real& x, int kept, int guard) {
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

/// Bounds on critical force number `index` from a value of so many digits, the last four of which rounding
/// may have spoilt. Nothing when they do not suffice.
template <Floating Real>
std::optional<ForceEnclosure> enclose(const ExactCount& count, std::size_t index, const Real& value,
                                      int digits, int working_digits) {
  for (int guard = 3; digits + guard + 4 <= working_digits; guard += 6) {
    const Bounds at = bounds(value, digits, guard);
    if (!at.agree && guard < 20) continue;
    const std::size_t below_low = count.below(at.low), below_high = count.below(at.high);
    if (below_low < index && index <= below_high) return {{index, at.low, at.high, below_low, below_high}};
    return std::nullopt;
  }
  return std::nullopt;
}

/// Adds to the enclosures found so far, from forces in a type of so many digits.
template <Floating Real>
void enclose_further(std::vector<ForceEnclosure>& result, const ExactCount& count,
                     const Chain<Rational>& chain, std::size_t wanted, int digits, int working_digits) {
  const std::vector<Real> forces = critical_forces(from_rational<Real>(chain), wanted);
  while (result.size() < wanted) {
    const std::size_t index = result.size() + 1;
    if (index > 1 && result.back().below_high >= index) {  // a tie: the same bounds
      result.push_back(result.back());
      result.back().index = index;
      continue;
    }
    const auto enclosed = enclose(count, index, forces[index - 1], digits, working_digits);
    if (!enclosed) return;
    result.push_back(*enclosed);
  }
}

/// As many digits as three words of 64 bits hold, kept in place: what fifty certified ones take, mostly.
constexpr int quick_digits = 57;
using Quick = mp::number<mp::mpfr_float_backend<quick_digits, mp::allocate_stack>, mp::et_off>;

}  // namespace

std::vector<ForceEnclosure> enclose_critical_forces(const Chain<Rational>& chain, std::size_t lowest,
                                                    int digits) {
  const ExactCount count(chain);
  const std::size_t wanted = std::min(lowest, mode_count(chain));
  std::vector<ForceEnclosure> result;
  if (digits + 7 <= quick_digits) enclose_further<Quick>(result, count, chain, wanted, digits, quick_digits);
  for (int working_digits = digits + 12; result.size() < wanted; working_digits += 12) {
    const WorkingPrecision precision(working_digits);
    enclose_further<Mpfr>(result, count, chain, wanted, digits, working_digits);
  }
  return result;
}

}  // namespace plumbline::proofs
