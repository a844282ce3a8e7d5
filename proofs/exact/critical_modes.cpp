#include "proofs/exact/critical_modes.hpp"

#include <algorithm>
#include <plumbline/base/parallel.hpp>
#include <plumbline/straight/buckling_mode.hpp>

#include "proofs/exact/decimal.hpp"
#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/exact_count.hpp"
#include "proofs/exact/exactly.hpp"
#include "proofs/exact/shapes_in_lanes.hpp"
#include "proofs/exact/tie.hpp"
#include "proofs/exact/working_precision.hpp"

namespace plumbline::proofs {
namespace {

/// The force rounded to nearest. Where its bounds do not settle that, it lies next to the number half-way
/// between two decimals, or on it, and an exact count says on which side.
std::string rounded(const ForceEnclosure& force, const StraightChain<Rational>& chain, int digits) {
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
bool tied(const StraightChain<Rational>& chain, std::size_t index, const Mpfr& first, const Mpfr& second,
          int digits) {
  const Rational slack = 1 + shifted(Rational(1), 12 - digits);
  const ExactCount count(chain);
  const Rational low = exactly(first) / slack, high = exactly(second) * slack;
  const ForceEnclosure bounds{index, low, high, count.below(low), count.below(high)};
  return bounds.below_low + 1 == index && bounds.below_high == index + 1 && find_tie(chain, bounds);
}

/// The lowest modes, computed with so many digits, in the order of their forces; those of equal forces in the
/// order of the parts that bend. Nothing where the digits do not tell the order.
std::optional<std::vector<Mode<Mpfr>>> modes_with(int digits, const StraightChain<Rational>& chain,
                                                  std::size_t lowest) {
  const WorkingPrecision precision(digits);
  const auto rounded = from_rational<Mpfr>(chain.chain);
  // one more, which may be as low as the last one wanted
  auto modes = critical_modes(StraightChain<Mpfr>(rounded, chain.end_point),
                              std::min(lowest, mode_count(chain.chain)) + 1);
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

/// A shape in numbers of two precisions, the first with so many digits.
ShapeInLanes shape_in_digits(const Mode<Mpfr>& mode, const Mode<Mpfr>& with_more_digits) {
  std::vector<Mpfr> q = mode.q;
  clear_noise(q, with_more_digits.q);
  const Mpfr scale = largest_angle(q);
  ShapeInLanes shape{{}, {}, exactly(mode.fy / scale)};
  for (Mpfr& angle : q) {
    if (angle != 0) angle /= scale;
    shape.q.push_back(angle == 0 ? 0.0 : static_cast<double>(angle));
  }
  shape.signs = sign_pattern(q);
  return shape;
}

/// The shapes of the lowest modes, all in numbers of as many digits as tell their order.
std::vector<ShapeInLanes> shapes_in_digits(const StraightChain<Rational>& chain, std::size_t lowest,
                                           int digits) {
  for (int working_digits = digits + 30;; working_digits *= 2) {
    const auto modes = modes_with(working_digits, chain, lowest);
    const auto again = modes_with(working_digits + 20, chain, lowest);
    if (!modes || !again) continue;
    const WorkingPrecision precision(working_digits);
    std::vector<ShapeInLanes> shapes;
    for (std::size_t m = 0; m < modes->size(); ++m)
      shapes.push_back(shape_in_digits((*modes)[m], (*again)[m]));
    return shapes;
  }
}

/// One of them from where its force is known to be; nothing where that does not lead there.
std::optional<Mode<Mpfr>> mode_near(const ForceInLanes& force, const StraightChain<Mpfr>& chain,
                                    const detail::BeadString<Mpfr>& string) {
  const auto pieces = string.pieces();
  const auto root = detail::refined(pieces[force.part], force.index, Mpfr(force.value));
  if (!root) return std::nullopt;
  return detail::mode_of(chain, pieces[force.part], *root);
}

/// Whether no two of them are so close that more digits are needed to tell them apart.
bool apart(const std::vector<ForceInLanes>& forces) {
  const auto close = [](const ForceInLanes& a, const ForceInLanes& b) {
    return b.value - a.value < a.value * 1e-18;
  };
  return std::adjacent_find(forces.begin(), forces.end(), close) == forces.end();
}

/// Shapes in lanes, and in more digits where two doubles leave something open; nothing where they leave the
/// order of the modes open, or a mode is not where they say.
std::optional<std::vector<ShapeInLanes>> shapes_mostly_in_lanes(const StraightChain<Rational>& chain,
                                                                std::size_t lowest, int digits) {
  std::vector<ForceInLanes> forces = forces_in_lanes(chain, std::min(lowest, mode_count(chain.chain)) + 1);
  if (forces.empty() || !apart(forces)) return std::nullopt;
  if (forces.size() > lowest) forces.resize(lowest);
  auto shapes = shapes_in_lanes(chain, forces);
  std::vector<std::size_t> open;
  for (std::size_t m = 0; m < shapes.size(); ++m) {
    if (!shapes[m]) open.push_back(m);
  }
  std::vector<std::optional<Mode<Mpfr>>> modes(open.size()), again(open.size());
  const auto compute = [&](auto& result, int working_digits) {
    const WorkingPrecision precision(working_digits);
    const auto exact = from_rational<Mpfr>(chain.chain);
    const StraightChain<Mpfr> straight(exact, chain.end_point);
    const detail::BeadString<Mpfr> string(straight);
    in_parallel(open.size(), threads_for(open.size(), chain.chain.size()),
                [&](std::size_t o) { result[o] = mode_near(forces[open[o]], straight, string); });
  };
  if (!open.empty()) {
    compute(again, digits + 50);
    compute(modes, digits + 30);
  }
  const WorkingPrecision precision(digits + 30);
  for (std::size_t o = 0; o < open.size(); ++o) {
    if (!modes[o] || !again[o]) return std::nullopt;
    shapes[open[o]] = shape_in_digits(*modes[o], *again[o]);
  }
  std::vector<ShapeInLanes> result;
  for (auto& shape : shapes) result.push_back(*std::move(shape));
  return result;
}

}  // namespace

std::vector<CriticalMode> modes_in_decimals(const StraightChain<Rational>& chain, std::size_t lowest,
                                            int digits) {
  std::vector<CriticalMode> modes = forces_in_decimals(chain, lowest, digits);
  std::optional<std::vector<ShapeInLanes>> shapes;
  if (chain.chain.size() >= long_chain) shapes = shapes_mostly_in_lanes(chain, lowest, digits);
  if (!shapes) shapes = shapes_in_digits(chain, lowest, digits);
  for (std::size_t m = 0; m < modes.size(); ++m) {
    modes[m].signs = std::move((*shapes)[m].signs);
    modes[m].q = std::move((*shapes)[m].q);
    modes[m].fy = std::move((*shapes)[m].fy);
  }
  return modes;
}

std::vector<CriticalMode> forces_in_decimals(const StraightChain<Rational>& chain, std::size_t lowest,
                                             int digits) {
  std::vector<CriticalMode> modes;
  for (const ForceEnclosure& force : enclose_critical_forces(chain, lowest, digits)) {
    const std::string text = rounded(force, chain, digits);
    constexpr int most = 15;
    modes.push_back({text, digits > most ? rounded(force, chain, most) : text, {}, 0, {}});
  }
  return modes;
}

}  // namespace plumbline::proofs
