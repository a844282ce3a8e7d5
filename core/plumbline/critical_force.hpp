#pragma once
/// \file
/// Critical forces of the straight chain to high relative accuracy for any grading, each in O(n): the
/// frequencies of a string with beads (bead_string.hpp), found by Laguerre's iteration inside brackets that
/// counts of the critical forces below a force keep safe.

#include <plumbline/lowest_force.hpp>
#include <plumbline/mode.hpp>

namespace plumbline {

/// The number of critical forces below F, each as often as it occurs.
/// \throws Error for n = 1 or a mechanism
template <Ordered Real>
std::size_t count_below(const Chain<Real>& chain, const Real& F) {
  const BeadString<Real> string(chain);
  std::size_t count = 0;
  for (const auto& piece : string.pieces()) count += count_below(piece, F);
  return count;
}

/// Runs along the string at the next points of the last few open brackets: one, or as many as there are
/// lanes.
template <Floating Real>
std::vector<Sweep<Real, 2>> sweeps(const StringPiece<Real>& string, std::span<const Bracket<Real>> brackets) {
  std::vector<Sweep<Real, 2>> result;
  if constexpr (std::same_as<Real, double>) {
    constexpr std::size_t vectors = 2;
    if (brackets.size() > 1) {
      Lanes F[vectors];
      double largest = 0;
      for (std::size_t i = 0; i < vectors * lane_count; ++i) {
        const double next = brackets[std::min(i, brackets.size() - 1)].next;
        F[i / lane_count][i % lane_count] = next;
        largest = std::max(largest, next);
      }
      Sweep<Lanes, 2, LaneBits> found[vectors];
      sweep(string, F, found, SafeStretch<double>(string, largest));
      for (std::size_t i = 0; i < brackets.size(); ++i) {
        const auto& [f, below] = found[i / lane_count];
        const std::size_t lane = i % lane_count;
        result.push_back({{f[0][lane], f[1][lane], f[2][lane]}, static_cast<std::size_t>(below[lane])});
      }
      return result;
    }
  }
  for (const auto& bracket : brackets) result.push_back(sweep(string, bracket.next));
  return result;
}

/// The two parts of a bracket of several roots on either side of its next point, each with a place to go on.
template <Floating Real>
std::array<Bracket<Real>, 2> split(const Bracket<Real>& bracket, const Sweep<Real, 2>& at,
                                   std::size_t degree) {
  const Real x = bracket.next;
  const std::size_t below = std::clamp(at.below, bracket.below, bracket.up_to);  // whatever rounding does
  std::array<Bracket<Real>, 2> parts{Bracket<Real>{bracket.low, x, bracket.below, below, x, bracket.rate},
                                     Bracket<Real>{x, bracket.high, below, bracket.up_to, x, bracket.rate}};
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

/// The lowest `wanted` roots of a string, ascending, by bisection down to single roots.
template <Floating Real>
std::vector<Root<Real>> roots_by_brackets(const StringPiece<Real>& string, std::size_t wanted) {
  if (wanted == 0) return {};
  constexpr std::size_t at_once = std::same_as<Real, double> ? 2 * lane_count : 1;
  std::vector<Root<Real>> roots(std::min(wanted, string.size()));
  std::vector<Bracket<Real>> open{all_of(string)};
  const auto settle = [&](const Bracket<Real>& bracket) {
    const std::size_t end = std::min(bracket.up_to, roots.size());
    for (std::size_t i = bracket.below; i < end; ++i) roots[i] = {bracket.next, bracket.rate};
  };
  while (!open.empty()) {
    const std::size_t first = open.size() - std::min(open.size(), at_once);
    const std::vector<Bracket<Real>> now(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
    open.resize(first);
    const auto found = sweeps<Real>(string, now);
    for (std::size_t i = 0; i < now.size(); ++i) {
      Bracket<Real> bracket = now[i];
      if (bracket.single()) {
        close_in(bracket, found[i], string.size()) ? settle(bracket) : open.push_back(bracket);
        continue;
      }
      for (const auto& part : split(bracket, found[i], string.size())) {
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
using RootsOfPieces = std::vector<std::vector<Root<Real>>>;

/// As few digits as will do come first: each wider type takes one more step from the roots in a narrower one.
template <Floating Real>
RootsOfPieces<Real> lowest_roots(const Chain<Real>& chain, std::size_t wanted);

/// Double is the narrowest. Where a chain leaves its range, the 15-bit exponents of long double take over.
template <>
inline RootsOfPieces<double> lowest_roots(const Chain<double>& chain, std::size_t wanted) {
  const BeadString<double> string(chain);
  RootsOfPieces<double> result;
  if (!string.in_range()) {
    const Chain<long double> wide = widened(chain);
    for (const auto& piece : BeadString<long double>(wide).pieces()) {
      result.emplace_back();
      for (const auto& root : roots_by_brackets(piece, wanted)) {
        result.back().push_back({force_in_double(root.value), static_cast<double>(root.rate)});
      }
    }
    return result;
  }
  for (const auto& piece : string.pieces()) {
    if (wanted == 1) {
      result.push_back({lowest_force(piece)});
    } else {
      result.push_back(roots_by_brackets(piece, wanted));
    }
  }
  return result;
}

template <Floating Real>
RootsOfPieces<Real> lowest_roots(const Chain<Real>& chain, std::size_t wanted) {
  using Narrow = std::conditional_t<std::same_as<Real, long double>, double, long double>;
  const BeadString<Real> string(chain);
  RootsOfPieces<Narrow> near;
  if (const auto narrow = narrowed<Narrow>(chain); narrow && BeadString<Narrow>(*narrow).in_range()) {
    near = lowest_roots(*narrow, wanted);
  }
  RootsOfPieces<Real> result;
  for (const auto& piece : string.pieces()) {
    std::vector<Root<Real>> roots;
    if (const std::size_t p = result.size(); p < near.size()) {
      for (const auto& [value, rate] : near[p]) {
        const auto root = refined(piece, roots.size(), Root<Real>{Real(value), Real(rate)}, 8);
        if (!root) break;
        roots.push_back(*root);
      }
    }
    if (roots.size() < std::min(wanted, piece.size())) roots = roots_by_brackets(piece, wanted);
    result.push_back(std::move(roots));
  }
  return result;
}

/// The lowest critical forces, ascending, each as often as it occurs: `lowest` of them, or all n - 1 when
/// there are not more. The relative error is a few units in the last place, growing no faster than n and in
/// practice like its square root, whatever the grading.
/// \throws Error for n = 1, a mechanism, or a force outside the range of the type
template <Floating Real>
std::vector<Real> critical_forces(const Chain<Real>& chain, std::size_t lowest) {
  mode_count(chain);
  std::vector<Real> forces;
  for (const auto& roots : lowest_roots(chain, lowest)) {
    const auto before = static_cast<std::ptrdiff_t>(forces.size());
    for (const auto& root : roots) forces.push_back(root.value);
    if (before > 0) std::inplace_merge(forces.begin(), forces.begin() + before, forces.end());
  }
  forces.resize(std::min(lowest, forces.size()));
  return forces;
}

}  // namespace plumbline
