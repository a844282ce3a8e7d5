#include "proofs/critical_modes.hpp"

#include <algorithm>
#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/decimal.hpp"
#include "proofs/enclosure.hpp"
#include "proofs/exact_count.hpp"
#include "proofs/exactly.hpp"
#include "proofs/tie.hpp"
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

std::size_t first_bent(const Mode<Mpfr>& mode) {
  return static_cast<std::size_t>(
      std::find_if(mode.q.begin(), mode.q.end(), [](const Mpfr& q) { return q != 0; }) - mode.q.begin());
}

/// Whether two forces that so many digits hardly tell apart are equal.
bool tied(const Chain<Rational>& chain, std::size_t index, const Mpfr& first, const Mpfr& second,
          int digits) {
  const Rational slack = 1 + shifted(Rational(1), 12 - digits);
  const ExactCount count(chain);
  const Rational low = exactly(first) / slack, high = exactly(second) * slack;
  const ForceEnclosure bounds{index, low, high, count.below(low), count.below(high)};
  return bounds.below_low + 1 == index && bounds.below_high == index + 1 && find_tie(chain, bounds);
}

/// The lowest modes, computed with so many digits, in the order of their forces; those of equal forces in the
/// order of the parts that bend. Nothing where the digits do not tell the order.
std::optional<std::vector<Mode<Mpfr>>> modes_with(int digits, const Chain<Rational>& chain,
                                                  std::size_t lowest) {
  const WorkingPrecision precision(digits);
  // one more, which may be as low as the last one wanted
  auto modes = critical_modes(from_rational<Mpfr>(chain), std::min(lowest, mode_count(chain)) + 1);
  const Mpfr close = pow(Mpfr(10), 8 - digits);
  for (std::size_t m = 0; m + 1 < modes.size(); ++m) {
    if (modes[m + 1].force - modes[m].force > close * modes[m].force) continue;
    if (!tied(chain, m + 1, modes[m].force, modes[m + 1].force, digits)) return std::nullopt;
    if (first_bent(modes[m + 1]) < first_bent(modes[m])) std::swap(modes[m], modes[m + 1]);
  }
  if (modes.size() > lowest) modes.resize(lowest);
  return modes;
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
  const int factor_digits = std::min(digits, 15);
  int working_digits = digits + 30;
  auto found = modes_with(working_digits, chain, lowest);
  auto again = modes_with(working_digits + 20, chain, lowest);
  while (!found || !again) {
    working_digits *= 2;
    found = modes_with(working_digits, chain, lowest);
    again = modes_with(working_digits + 20, chain, lowest);
  }
  std::vector<Mode<Mpfr>>& modes = *found;
  const WorkingPrecision precision(working_digits);
  std::vector<CriticalMode> result;
  for (std::size_t m = 0; m < modes.size(); ++m) {
    std::vector<Mpfr>& q = modes[m].q;
    clear_noise(q, (*again)[m].q);
    const Mpfr scale = largest_angle(q);
    result.push_back({rounded(forces[m], chain, digits),
                      rounded(forces[m], chain, factor_digits),
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
