#include "proofs/critical_modes.hpp"

#include <algorithm>
#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/decimal.hpp"
#include "proofs/enclosure.hpp"
#include "proofs/exact_count.hpp"
#include "proofs/exactly.hpp"
#include "proofs/working_precision.hpp"

namespace plumbline::proofs {
namespace {

/// The force rounded to nearest. Where its bounds do not settle that, it lies next to the number half-way
/// between two decimals, or on it, and an exact count says on which side.
std::string rounded(const ForceEnclosure& force, const Chain<Rational>& chain, int digits) {
  const std::string low = to_decimal(force.low, digits), high = to_decimal(force.high, digits);
  if (low == high) return low;
  const Rational half_way = (*parse_decimal(low) + *parse_decimal(high)) / 2;
  return ExactCount(chain).below(half_way) >= force.index ? low : high;
}

/// The lowest modes, computed with so many digits.
std::vector<Mode<Mpfr>> modes_with(int working_digits, const Chain<Rational>& chain, std::size_t lowest) {
  const WorkingPrecision precision(working_digits);
  return critical_modes(from_rational<Mpfr>(chain), lowest);
}

/// A joint that does not turn comes out as whatever rounding leaves; more digits leave something else.
void clear_noise(std::vector<Mpfr>& q, const std::vector<Mpfr>& with_more_digits) {
  for (std::size_t i = 0; i < q.size(); ++i) {
    const Mpfr change = abs(q[i] - with_more_digits[i]);
    if (change * 1000000 > abs(with_more_digits[i])) q[i] = 0;
  }
}

/// The size of the largest angle, with the sign of the first that is not zero.
Mpfr largest_angle(const std::vector<Mpfr>& q) {
  const auto smaller = [](const Mpfr& a, const Mpfr& b) { return abs(a) < abs(b); };
  const Mpfr largest = abs(*std::max_element(q.begin(), q.end(), smaller));
  const auto first = std::find_if(q.begin(), q.end(), [](const Mpfr& angle) { return angle != 0; });
  return *first < 0 ? Mpfr(-largest) : largest;
}

}  // namespace

std::vector<CriticalMode> modes_in_decimals(const Chain<Rational>& chain, std::size_t lowest, int digits) {
  const std::vector<ForceEnclosure> forces = enclose_critical_forces(chain, lowest, digits);
  const int working_digits = digits + 30, factor_digits = std::min(digits, 15);
  std::vector<Mode<Mpfr>> modes = modes_with(working_digits, chain, lowest);
  const std::vector<Mode<Mpfr>> again = modes_with(working_digits + 20, chain, lowest);
  const WorkingPrecision precision(working_digits);
  const auto approximate = from_rational<Mpfr>(chain);
  std::vector<CriticalMode> result;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<Mpfr>& q = modes[m].q;
    clear_noise(q, again[m].q);
    const Mpfr scale = largest_angle(q);
    result.push_back({rounded(forces[m], chain, digits),
                      to_decimal(exactly(energy_factor(approximate, q)), factor_digits),
                      {},
                      exactly(modes[m].fy / scale),
                      {}});
    for (Mpfr& angle : q)
      result.back().q.push_back(static_cast<double>(angle == 0 ? angle = 0 : angle /= scale));
    result.back().signs = sign_pattern(q);
  }
  return result;
}

}  // namespace plumbline::proofs
