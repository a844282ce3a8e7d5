#include "proofs/exact/enclosure.hpp"

#include <algorithm>
#include <plumbline/straight/critical_force.hpp>
#include <string>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/exact_count.hpp"
#include "proofs/exact/forces_in_lanes.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {
namespace {

/// Two units on either side of x in the digit after `kept` + `guard` significant ones, and whether the two
/// ends round to the same decimal of `kept` digits.
struct DecimalBounds {
  Rational low, high;
  bool agree;
};
template <Floating Real>
DecimalBounds bounds(const Real& x, int kept, int guard) {
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

/// What is found of the lowest critical forces; nothing where the digits have not sufficed yet.
using Found = std::vector<std::optional<ForceEnclosure>>;

/// Two forces closer to each other than the digits have the bounds of the first.
void share_ties(Found& found) {
  for (std::size_t i = 1; i < found.size(); ++i) {
    const auto& before = found[i - 1];
    if (!before || before->below_high <= i) continue;
    found[i] = before;
    found[i]->index = i + 1;
  }
}

/// Encloses what is still open from the values of the forces, the last four of whose digits rounding may have
/// spoilt.
template <Floating Real>
void enclose_open(Found& found, const ExactCount& count, const std::vector<Real>& values, int digits,
                  int working_digits) {
  std::vector<std::size_t> open;
  std::vector<Rational> ends;
  for (std::size_t i = 0; i < std::min(found.size(), values.size()); ++i) {
    if (found[i]) continue;
    for (int guard = 3; digits + guard + 4 <= working_digits; guard += 6) {
      const DecimalBounds at = bounds(values[i], digits, guard);
      if (!at.agree && guard < 20) continue;
      open.push_back(i);
      ends.push_back(at.low);
      ends.push_back(at.high);
      break;
    }
  }
  const std::vector<std::size_t> below = count.below(ends);
  for (std::size_t o = 0; o < open.size(); ++o) {
    const std::size_t index = open[o] + 1, below_low = below[2 * o], below_high = below[2 * o + 1];
    if (below_low < index && index <= below_high)
      found[open[o]] = {index, ends[2 * o], ends[2 * o + 1], below_low, below_high};
  }
  share_ties(found);
}

/// Roots to so many digits from those to a third of them, and so on down to what double leads to: a run with
/// three derivatives makes more than three times as many digits right, and the last one costs most.
detail::RootsOfPieces<Mpfr> roots_in_steps(const Chain<Rational>& chain, std::size_t lowest, int digits) {
  constexpr int few = 80, lost = 8;
  if (digits <= few) {
    const WorkingPrecision precision(digits);
    return detail::lowest_roots(from_rational<Mpfr>(chain), lowest);
  }
  const auto near = roots_in_steps(chain, lowest, digits / 3 + lost);
  const WorkingPrecision precision(digits);
  const auto rounded = from_rational<Mpfr>(chain);
  const detail::BeadString<Mpfr> string(rounded);
  detail::RootsOfPieces<Mpfr> roots;
  for (const auto& piece : string.pieces()) {
    std::vector<Mpfr>& own = roots.emplace_back();
    for (const Mpfr& value : near[roots.size() - 1]) {
      Mpfr start(0);  // of this precision
      mpfr_set(start.backend().data(), value.backend().data(), MPFR_RNDN);
      const auto root = detail::refined(piece, own.size(), start);
      if (!root) return detail::lowest_roots(rounded, lowest);
      own.push_back(*root);
    }
  }
  return roots;
}

/// The lowest critical forces, computed with so many digits.
std::vector<Mpfr> forces_in_steps(const Chain<Rational>& chain, std::size_t lowest, int digits) {
  std::vector<Mpfr> forces;
  for (const auto& roots : roots_in_steps(chain, lowest, digits))
    forces.insert(forces.end(), roots.begin(), roots.end());
  std::sort(forces.begin(), forces.end());
  forces.resize(std::min(lowest, forces.size()));
  return forces;
}

bool complete(const Found& found) {
  return std::all_of(found.begin(), found.end(), [](const auto& one) { return one.has_value(); });
}

}  // namespace

std::vector<ForceEnclosure> enclose_critical_forces(const Chain<Rational>& chain, std::size_t lowest,
                                                    int digits) {
  const ExactCount count(chain);
  Found found(std::min(lowest, mode_count(chain)));
  if (digits + 7 <= lane_digits && chain.size() >= long_chain) {
    std::vector<Wide> values;
    for (const ForceInLanes& force : forces_in_lanes(chain, found.size())) values.push_back(force.value);
    enclose_open(found, count, values, digits, lane_digits);
  }
  for (int working_digits = digits + 12; !complete(found); working_digits += 12) {
    const WorkingPrecision precision(working_digits);
    enclose_open(found, count, forces_in_steps(chain, found.size(), working_digits), digits, working_digits);
  }
  std::vector<ForceEnclosure> result;
  for (const auto& one : found) result.push_back(*one);
  return result;
}

}  // namespace plumbline::proofs
