#pragma once
/// \file
/// Critical forces of the straight chain to high relative accuracy for any grading, each in O(n): the
/// frequencies of a string with beads (bead_string.hpp), found by Laguerre's iteration inside brackets that
/// counts of the critical forces below a force keep safe.
///
/// \code{.cpp}
/// const Chain<double> chain({1, 1, 1, 1}, {1, 1, 1, 1});
/// const std::vector<double> forces = critical_forces(chain, 3);
/// assert(std::abs(forces[0] - 0.924027591295903) < 1e-15);
///
/// // two counts in fractions prove it: no critical force is below the first, one below the second
/// const Chain<Rational> exact({1, 1, 1, 1}, {1, 1, 1, 1});
/// assert(count_below(exact, Rational("924027591295903/1000000000000000")) == 0);
/// assert(count_below(exact, Rational("924027591295904/1000000000000000")) == 1);
/// \endcode

#include <plumbline/base/widest.hpp>
#include <plumbline/chain/mode.hpp>
#include <plumbline/straight/lowest_force.hpp>

namespace plumbline {

/// The number of critical forces below F, each as often as it occurs.
/// \throws Error for n = 1 or a mechanism
template <Ordered Real>
std::size_t count_below(const StraightChain<Real>& chain, const Real& F) {
  const detail::BeadString<Real> string(chain);
  std::size_t count = 0;
  for (const auto& piece : string.pieces()) count += count_below(piece, F);
  return count;
}
/// The same with the end point guided.
template <Ordered Real>
std::size_t count_below(const Chain<Real>& chain, const Real& F) {
  return count_below(StraightChain<Real>(chain), F);
}

namespace detail {

/// Runs along the string at the next points of a few open brackets: as many as there are lanes, twice.
inline void sweep_in_lanes(const StringPiece<double>& string, std::span<const Bracket<double>> brackets,
                           std::span<Sweep<double, 3>> found) {
  in_widest([&] {
    std::array<Lanes, 2> F;
    double largest = 0;
    for (std::size_t i = 0; i < 2 * lane_count; ++i) {
      const double next = brackets[std::min(i, brackets.size() - 1)].next;
      F[i / lane_count][i % lane_count] = next;
      largest = std::max(largest, next);
    }
    const auto side_by_side = sweep<3>(string, F, SafeStretch<double>(string, largest));
    for (std::size_t i = 0; i < brackets.size(); ++i) {
      const auto& [f, below] = side_by_side[i / lane_count];
      const std::size_t lane = i % lane_count;
      for (std::size_t t = 0; t < 4; ++t) found[i].f[t] = f[t][lane];
      found[i].below = static_cast<std::size_t>(below[lane]);
    }
  });
}

/// Runs along the string at the next points of a few open brackets: one, or as many as there are lanes.
template <Floating Real>
void sweep_all(const StringPiece<Real>& string, std::span<const Bracket<Real>> brackets,
               std::span<Sweep<Real, 3>> found) {
  if constexpr (std::same_as<Real, double>) {
    if (brackets.size() > 1) return sweep_in_lanes(string, brackets, found);
  }
  for (std::size_t i = 0; i < brackets.size(); ++i) found[i] = sweep<3>(string, brackets[i].next);
}

/// The two parts of a bracket of several roots on either side of its next point, each with a place to go on.
template <Floating Real>
std::array<Bracket<Real>, 2> split(const Bracket<Real>& bracket, const Sweep<Real, 3>& at,
                                   std::size_t degree) {
  const Real x = bracket.next;
  const std::size_t below = std::clamp(at.below, bracket.below, bracket.up_to);  // whatever rounding does
  std::array<Bracket<Real>, 2> parts{Bracket<Real>{bracket.low, x, bracket.below, below, x},
                                     Bracket<Real>{x, bracket.high, below, bracket.up_to, x}};
  for (Bracket<Real>& part : parts) {
    // A single root may be stepped to; close_in sees to it that the step stays inside.
    if (!part.single() || at.f[0] == Real(0)) {
      part.halve();
    } else if (close_in(part, at, degree)) {
      part.low = part.high = part.next;
    }
  }
  return parts;
}

/// The lowest `wanted` roots of what is swept, a string or a pencil, ascending, by bisection down to single
/// roots.
template <template <class> class Swept, Floating Real>
std::vector<Real> roots_by_brackets(const Swept<Real>& string, std::size_t wanted) {
  constexpr std::size_t at_once = std::same_as<Real, double> ? 2 * lane_count : 1;
  std::vector<Real> roots(std::min(wanted, string.size()));
  std::vector<Bracket<Real>> open{all_of(string)};
  const auto settle = [&](const Bracket<Real>& bracket) {
    const std::size_t end = std::min(bracket.up_to, roots.size());
    for (std::size_t i = bracket.below; i < end; ++i) roots[i] = bracket.next;
  };
  std::array<Sweep<Real, 3>, at_once> found;
  while (!open.empty()) {
    const std::size_t first = open.size() - std::min(open.size(), at_once);
    const std::vector<Bracket<Real>> now(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
    open.resize(first);
    sweep_all(string, std::span<const Bracket<Real>>(now), std::span<Sweep<Real, 3>>(found));
    for (std::size_t i = 0; i < now.size(); ++i) {
      Bracket<Real> bracket = now[i];
      if (bracket.single()) {
        close_in(bracket, found[i], string.degree()) ? settle(bracket) : open.push_back(bracket);
        continue;
      }
      for (const auto& part : split(bracket, found[i], string.degree())) {
        if (part.below == part.up_to || part.below >= roots.size()) continue;
        const bool closed = !(part.low < part.next && part.next < part.high);  // down to the last digit
        closed ? settle(part) : open.push_back(part);
      }
    }
  }
  return roots;
}

/// A chain in a floating-point type with fewer digits; nothing when an entry leaves its range.
template <std::floating_point To, Floating From>
std::optional<Chain<To>> narrowed(const Chain<From>& chain) {
  bool fits = true;
  const auto all = [&](const std::vector<From>& values) {
    std::vector<To> result;
    result.reserve(values.size());
    for (const From& value : values) {
      result.push_back(static_cast<To>(value));
      fits = fits && std::isfinite(result.back()) && (result.back() > To(0)) == (value > From(0));
    }
    return result;
  };
  auto length = all(chain.length()), stiffness = all(chain.stiffness());
  if (!fits) return std::nullopt;
  return Chain<To>(std::move(length), std::move(stiffness));
}

/// The same chain, with the exponents of long double.
inline Chain<long double> widened(const Chain<double>& chain) {
  return convert<long double>(chain, [](double value) { return static_cast<long double>(value); });
}

/// \throws Error where double has no such number
inline double force_in_double(long double force) {
  const auto result = static_cast<double>(force);
  if (!std::isnormal(result)) {
    throw Error("critical force", "a value outside the range of double",
                "lengths and stiffnesses less far apart");
  }
  return result;
}

/// The lowest roots of each piece of a chain's string.
template <Floating Real>
using RootsOfPieces = std::vector<std::vector<Real>>;

/// Nothing where a chain leaves the range of double on the way.
inline std::optional<RootsOfPieces<double>> lowest_roots_in_range(const StraightChain<double>& chain,
                                                                  std::size_t wanted) {
  const BeadString<double> string(chain);
  if (!string.in_range()) return std::nullopt;
  RootsOfPieces<double> result;
  for (const auto& piece : string.pieces()) {
    result.push_back(wanted == 1 ? std::vector{lowest_force(piece)} : roots_by_brackets(piece, wanted));
  }
  return result;
}

/// The root number `index` from a value that is nearly it. Nothing when it turns out that it is not.
template <Floating Real>
std::optional<Real> refined(const StringPiece<Real>& string, std::size_t index, const Real& near) {
  using std::ldexp;
  Bracket<Real> bracket{Real(ldexp(near, -30)), Real(ldexp(near, 30)), index, index + 1, near};
  for (int runs = 0; runs < 8; ++runs) {
    const auto at = sweep<3>(string, bracket.next);
    if (at.below < index || at.below > index + 1) return std::nullopt;
    if (close_in(bracket, at, string.size())) return bracket.next;
  }
  return std::nullopt;
}

/// Digits of double come first, and a wider type takes a step or two more from there.
template <Floating Real>
RootsOfPieces<Real> lowest_roots(const StraightChain<Real>& chain, std::size_t wanted) {
  RootsOfPieces<double> near;
  if (const auto narrow = narrowed<double>(chain.chain)) {
    near = lowest_roots_in_range({*narrow, chain.end_point}, wanted).value_or(RootsOfPieces<double>());
  }
  const BeadString<Real> string(chain);
  RootsOfPieces<Real> result;
  for (const auto& piece : string.pieces()) {
    std::vector<Real> roots;
    if (const std::size_t p = result.size(); p < near.size()) {
      for (const double value : near[p]) {
        const auto root = refined(piece, roots.size(), Real(value));
        if (!root) break;
        roots.push_back(*root);
      }
    }
    if (roots.size() < std::min(wanted, piece.size())) roots = roots_by_brackets(piece, wanted);
    result.push_back(std::move(roots));
  }
  return result;
}

/// Where a chain leaves the range of double, the 15-bit exponents of long double take over.
template <>
inline RootsOfPieces<double> lowest_roots(const StraightChain<double>& chain, std::size_t wanted) {
  if (auto roots = lowest_roots_in_range(chain, wanted)) return *std::move(roots);
  RootsOfPieces<double> result;
  const Chain<long double> wide = widened(chain.chain);
  for (const auto& roots : lowest_roots(StraightChain<long double>(wide, chain.end_point), wanted)) {
    result.emplace_back();
    for (const long double root : roots) result.back().push_back(force_in_double(root));
  }
  return result;
}

}  // namespace detail

/// The lowest critical force, as critical_forces() gives it.
/// \throws Error for n = 1, a mechanism, or a force outside the range of the type
template <Floating Real>
Real lowest_critical_force(const StraightChain<Real>& chain) {
  if constexpr (std::same_as<Real, double>) {
    const detail::BeadString<double> string(chain);
    if (string.in_range()) {
      const auto pieces = string.pieces();
      const double first = detail::lowest_force(pieces[0]);
      return pieces.size() == 1 ? first : std::min(first, detail::lowest_force(pieces[1]));
    }
  }
  const auto roots = detail::lowest_roots(chain, 1);
  return roots.size() == 1 ? roots[0][0] : std::min(roots[0][0], roots[1][0]);
}
/// The same with the end point guided.
template <Floating Real>
Real lowest_critical_force(const Chain<Real>& chain) {
  return lowest_critical_force(StraightChain<Real>(chain));
}

/// The lowest critical forces, ascending, each as often as it occurs: `lowest` of them, or all n - 1 when
/// there are not more. The relative error is a few units in the last place, growing no faster than n and in
/// practice like its square root, whatever the grading.
/// \throws Error for n = 1, a mechanism, or a force outside the range of the type
template <Floating Real>
std::vector<Real> critical_forces(const StraightChain<Real>& chain, std::size_t lowest) {
  mode_count(chain.chain);
  std::vector<Real> forces;
  for (const auto& roots : detail::lowest_roots(chain, lowest)) {
    const auto before = static_cast<std::ptrdiff_t>(forces.size());
    forces.insert(forces.end(), roots.begin(), roots.end());
    if (before > 0) std::inplace_merge(forces.begin(), forces.begin() + before, forces.end());
  }
  forces.resize(std::min(lowest, forces.size()));
  return forces;
}
/// The same with the end point guided.
template <Floating Real>
std::vector<Real> critical_forces(const Chain<Real>& chain, std::size_t lowest) {
  return critical_forces(StraightChain<Real>(chain), lowest);
}

}  // namespace plumbline
