#pragma once
/// \file
/// One run of the recursion along a string with beads (bead_string.hpp) for one force F or for many at once.
/// It tells how many critical forces lie below F and, with two derivatives, where the nearest ones are.
///
/// Rounding perturbs each datum of the string only relatively: the result belongs exactly to a string near
/// by.

#include <plumbline/bead_string.hpp>

namespace plumbline {

/// What a run finds: up to a positive factor a function whose roots are the critical forces, with its Taylor
/// coefficients in the relative change of F, and the number of critical forces below F.
template <class T, int order, class Count = std::size_t>
struct Sweep {
  T f[order + 1];
  Count below;
};

/// Deflection h and slope g on the way, as Taylor polynomials in the relative change of F.
template <class T, int order>
struct StringState {
  T h[order + 1], g[order + 1];

  StringState(const T& deflection, const T& slope) : h{deflection}, g{slope} {
    for (int t = 1; t <= order; ++t) h[t] = g[t] = T{};
  }
  /// \param Fm force times mass
  template <class M>
  void pass_bead(const M& Fm) {
    for (int t = order; t > 0; --t) g[t] -= Fm * (h[t] + h[t - 1]);
    g[0] -= Fm * h[0];
  }
  template <class R>
  void pass_spacing(const R& r) {
    for (int t = 0; t <= order; ++t) h[t] += r * g[t];
  }
  void scale(const T& factor) {
    for (int t = 0; t <= order; ++t) {
      h[t] *= factor;
      g[t] *= factor;
    }
  }
};

/// How far a run may go before it threatens to leave the range of the type: measured in max(|h|, unit |g|), a
/// link multiplies by no more than (1 + rho)^2, rho^2 = F m r.
template <Ordered Real>
struct SafeStretch {
  std::size_t links = std::numeric_limits<std::size_t>::max();
  Real unit = Real(1);

  SafeStretch(const StringPiece<Real>& string, const Real& F) {
    if constexpr (std::floating_point<Real>) {
      const Real Fm = F * string.largest_mass;
      if (string.size() <= 16 && Fm * string.largest_spacing < Real(1 << 20)) return;  // 16 links: 2^352
      const Real bits = 2 * std::log2(1 + std::sqrt(Fm * string.largest_spacing));
      const Real room = std::numeric_limits<Real>::max_exponent / 2;
      links = static_cast<std::size_t>(std::max(Real(1), std::min(Real(1000), room / (bits + Real(0.01)))));
      if (string.largest_spacing > 0) unit = std::sqrt(string.largest_spacing / Fm);
    }
  }
  template <int order>
  void restore(StringState<Real, order>& state) const {
    if constexpr (std::floating_point<Real>) {
      if (links == std::numeric_limits<std::size_t>::max()) return;
      const Real size = std::max(std::abs(state.h[0]), unit * std::abs(state.g[0]));
      state.scale(std::ldexp(Real(1), -std::ilogb(size)));
    }
  }
};

/// The run from the left in any ordered field, exact ones included: only counts. Where F is itself a critical
/// force it is not below itself.
template <Ordered Real>
std::size_t count_below(const StringPiece<Real>& string, const Real& F) {
  const SafeStretch<Real> safe(string, F);
  StringState<Real, 0> state(Real(1), string.slope);
  std::size_t count = 0;
  bool negative = false;
  for (std::size_t i = 0; i < string.size(); ++i) {
    state.pass_bead(F * string.mass[i]);
    if (i < string.spacing.size()) state.pass_spacing(string.spacing[i]);
    const Real& end = i < string.spacing.size() ? state.h[0] : state.g[0];
    // A zero between two values has opposite signs beside it, and is one change; a zero at the end is none.
    const bool now_negative = end == Real(0) ? negative : end < Real(0);
    count += now_negative != negative ? 1 : 0;
    negative = now_negative;
    if ((i + 1) % safe.links == 0) safe.restore(state);
  }
  return count;
}

/// The run from both ends, joined at a bead in the middle: two halves that need not wait for each other.
template <Floating Real>
Sweep<Real, 2> sweep(const StringPiece<Real>& string, const Real& F) {
  const SafeStretch<Real> safe(string, F);
  StringState<Real, 2> left(Real(1), string.slope), right(Real(1), string.end_slope());
  std::size_t i = 0, j = string.size() - 1, below = 0;
  bool left_negative = false, right_negative = false;
  const auto step_left = [&] {
    left.pass_bead(F * string.mass[i]);
    left.pass_spacing(string.spacing[i++]);
    below += (left.h[0] < Real(0)) != left_negative;
    left_negative = left.h[0] < Real(0);
  };
  const auto step_right = [&] {
    right.pass_bead(F * string.mass[j]);
    right.pass_spacing(string.spacing[--j]);
    below += (right.h[0] < Real(0)) != right_negative;
    right_negative = right.h[0] < Real(0);
  };
  while (i + 1 < j) {
    const std::size_t links = std::min(safe.links, (j - i) / 2);
    for (std::size_t link = 0; link < links; ++link) {
      step_left();
      step_right();
    }
    safe.restore(left);
    safe.restore(right);
  }
  if (i < j) step_left();
  right.pass_bead(F * string.mass[j]);
  // The force that holds the halves together, times both deflections: left slope + right slope, each per
  // deflection. Where it has to push, one more critical force lies below F.
  Sweep<Real, 2> result{{}, below};
  for (int t = 0; t <= 2; ++t) {
    result.f[t] = left.g[0] * right.h[t] + right.g[0] * left.h[t];
    for (int s = 1; s <= t; ++s) result.f[t] += left.g[s] * right.h[t - s] + right.g[s] * left.h[t - s];
  }
  result.below += (result.f[0] < Real(0)) != (left_negative != right_negative);
  return result;
}

/// The run from the left for 8 * vectors forces at once.
template <std::size_t vectors>
void sweep(const StringPiece<double>& string, const Lanes (&F)[vectors],
           Sweep<Lanes, 2, LaneBits> (&result)[vectors], const SafeStretch<double>& safe) {
  using State = StringState<Lanes, 2>;
  std::array<State, vectors> state = [&]<std::size_t... v>(std::index_sequence<v...>) {
    return std::array<State, vectors>{((void)v, State(all_lanes(1), all_lanes(string.slope)))...};
  }
  (std::make_index_sequence<vectors>());
  for (auto& each : result) each.below = LaneBits{};
  for (std::size_t i = 0; i < string.spacing.size();) {
    const std::size_t stop = std::min(string.spacing.size(), i + std::min(safe.links, string.size()));
    for (; i < stop; ++i) {
      const double m = string.mass[i], r = string.spacing[i];
      for (std::size_t v = 0; v < vectors; ++v) {
        const Lanes before = state[v].h[0];
        state[v].pass_bead(F[v] * m);
        state[v].pass_spacing(r);
        result[v].below -= sign_differs(before, state[v].h[0]);
      }
    }
    for (State& each : state) {
      each.scale(to_unit_scale(larger(magnitude(each.h[0]), safe.unit * magnitude(each.g[0]))));
    }
  }
  for (std::size_t v = 0; v < vectors; ++v) {
    const Lanes before = state[v].h[0];
    if (string.free_end()) state[v].pass_bead(F[v] * string.mass.back());
    for (int t = 0; t <= 2; ++t) result[v].f[t] = string.free_end() ? state[v].g[t] : state[v].h[t];
    if (string.free_end()) result[v].below -= sign_differs(before, state[v].g[0]);
  }
}

}  // namespace plumbline
