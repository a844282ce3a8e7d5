#pragma once
/// \file
/// The straight chain under compression as a taut string with beads (proofs/theorems.md, theorem
/// "Recursion").
///
/// In h_i = z_1 q_1 + … + z_i q_i and g_i = k_i q_i / z_i, z_i = L_i + … + L_n, equations (29) and (30) read
///
///     g_{i+1} = g_i - F m_i h_i,   h_{i+1} = h_i + r_{i+1} g_{i+1},   h_0 = h_n = 0,
///
/// with m_i = L_i / (z_i z_{i+1}) and r_i = z_i^2 / k_i. That is a string of n - 1 beads of mass m_i, spaced
/// r_i apart and fixed at both ends: h is its deflection, g its slope, and the critical forces are the
/// squares of its frequencies. A passive joint is an infinite spacing: it cuts the string and leaves free
/// ends.

#include <algorithm>
#include <cmath>
#include <plumbline/chain.hpp>

namespace plumbline {

/// A piece of the string between cuts. All its frequencies are simple.
template <Number Real>
struct BeadString {
  std::size_t first;  ///< the joint (from 0) at its left end, and the chain's link that is its first bead
  std::vector<Real> mass;     ///< one a bead
  std::vector<Real> spacing;  ///< behind each bead; a free right end has one entry fewer
  Real slope;  ///< of the string before the first bead where that has deflection 1; 0 at a free end

  [[nodiscard]] std::size_t size() const { return mass.size(); }
};

/// The one or two pieces of a chain's string; together they have n - 1 beads.
/// \throws Error for n = 1 or a mechanism
template <Number Real>
std::vector<BeadString<Real>> bead_strings(const Chain<Real>& chain) {
  const std::size_t beads = mode_count(chain);
  const std::vector<Real> z = distance_to_end(chain);
  const auto& k = chain.stiffness();
  const auto passive = [&](std::size_t i) { return chain.passive_joint(i); };

  std::vector<BeadString<Real>> pieces;
  for (std::size_t i = 0; i < beads; ++i) {
    if (i == 0 || passive(i)) pieces.push_back({i, {}, {}, passive(i) ? Real(0) : k[i] / (z[i] * z[i])});
    pieces.back().mass.push_back(chain.length()[i] / z[i] / z[i + 1]);
    if (!passive(i + 1)) pieces.back().spacing.push_back(z[i + 1] / k[i + 1] * z[i + 1]);
  }
  return pieces;
}

/// State of the recursion at the right end of a string, up to a positive factor: the deflection there (at a
/// free end the slope), whose roots are the critical forces, with its first two Taylor coefficients in the
/// relative change of F, and the number of critical forces below F.
template <Number Real, int order>
struct EndState {
  Real h[order + 1];
  std::size_t count;
};

/// Multiplies h and g by a power of two when they threaten to leave the range of the type. Returns its
/// exponent. Exact types and MPFR have no such range.
template <Number Real, std::size_t terms>
int keep_in_range(Real (&h)[terms], Real (&g)[terms]) {
  if constexpr (std::floating_point<Real>) {
    constexpr int safe = std::numeric_limits<Real>::max_exponent / 4;
    static const Real high = std::ldexp(Real(1), safe), low = std::ldexp(Real(1), -safe);
    Real size(0);
    for (std::size_t t = 0; t < terms; ++t) size = std::max({size, std::abs(h[t]), std::abs(g[t])});
    if (size < low || size > high) {
      const int shift = -std::ilogb(size);
      for (std::size_t t = 0; t < terms; ++t) {
        h[t] = std::ldexp(h[t], shift);
        g[t] = std::ldexp(g[t], shift);
      }
      return shift;
    }
  }
  return 0;
}

/// Runs the recursion along a string.
template <int order, Ordered Real>
EndState<Real, order> sweep(const BeadString<Real>& string, const Real& F) {
  Real h[order + 1] = {Real(1)}, g[order + 1] = {string.slope};
  for (int t = 1; t <= order; ++t) h[t] = g[t] = Real(0);
  std::size_t count = 0;
  bool negative = false;
  for (std::size_t i = 0; i < string.size(); ++i) {
    const Real Fm = F * string.mass[i];
    for (int t = order; t > 0; --t) g[t] -= Fm * (h[t] + h[t - 1]);
    g[0] -= Fm * h[0];
    const bool free_end = i == string.spacing.size();
    for (int t = 0; t <= order; ++t) h[t] = free_end ? g[t] : Real(h[t] + string.spacing[i] * g[t]);
    // A zero between two values has opposite signs beside it, and is one change; a zero at the end is none.
    const bool now_negative = h[0] == Real(0) ? negative : h[0] < Real(0);
    count += now_negative != negative ? 1 : 0;
    negative = now_negative;
    keep_in_range(h, g);
  }
  EndState<Real, order> end;
  std::copy(std::begin(h), std::end(h), end.h);
  end.count = count;
  return end;
}

}  // namespace plumbline
