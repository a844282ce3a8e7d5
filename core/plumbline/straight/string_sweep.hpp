#pragma once
/// \file
/// One run of the recursion along a string with beads (bead_string.hpp) for one force F, for many at once, or
/// along many strings at once. It tells how many critical forces lie below F and, with derivatives, where the
/// nearest ones are.
///
/// Rounding perturbs each datum of the string only relatively: the result belongs exactly to a string near
/// by.

#include <array>
#include <plumbline/straight/bead_string.hpp>

namespace plumbline::detail {

/// The number of critical forces below F, lane by lane where there are lanes.
template <class T>
using Count = std::conditional_t<Vectorised<T>, Mask<T>, std::size_t>;

/// What a run finds: up to a positive factor a function whose roots are the critical forces, with its Taylor
/// coefficients in the relative change of F, and the number of critical forces below F.
template <class T, int order>
struct Sweep {
  std::array<T, order + 1> f;
  Count<T> below;
};

/// x += a b without a number in between, where numbers live on the heap.
template <class T, class M>
void add_product(T& x, const M& a, const T& b, T& between) {
  if constexpr (requires { x.backend(); }) {
    using mp::default_ops::eval_add, mp::default_ops::eval_multiply;
    eval_multiply(between.backend(), a.backend(), b.backend());
    eval_add(x.backend(), between.backend());
  } else {
    x += a * b;
  }
}

/// Deflection h and slope g on the way, as Taylor polynomials in the relative change of F.
template <class T, int order>
struct StringState {
  T h[order + 1], g[order + 1], between;

  StringState(const T& deflection, const T& slope) : h{deflection}, g{slope}, between{} {
    for (int t = 1; t <= order; ++t) h[t] = g[t] = T{};
  }
  /// \param push  minus force times mass
  template <class M>
  void pass_bead(const M& push) {
    for (int t = order; t > 0; --t) add_product(g[t], push, h[t - 1], between);
    for (int t = order; t >= 0; --t) add_product(g[t], push, h[t], between);
  }
  template <class R>
  void pass_spacing(const R& r) {
    for (int t = 0; t <= order; ++t) add_product(h[t], r, g[t], between);
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
template <class Real>
struct SafeStretch {
  std::size_t links = std::numeric_limits<std::size_t>::max();
  Real unit = Real(1);

  SafeStretch() = default;
  SafeStretch(const StringPiece<Real>& string, const Real& F) {
    if constexpr (std::floating_point<Real>) {
      const Real Fm = F * string.largest_mass;
      if (string.size() <= 16 && Fm * string.largest_spacing < Real(1 << 20)) return;  // 16 links: 2^352
      const Real bits = 2 * std::log2(1 + std::sqrt(Fm * string.largest_spacing));
      const Real room = Real(std::numeric_limits<Real>::max_exponent) / 4;  // squares are to come
      links = static_cast<std::size_t>(std::max(Real(1), std::min(Real(1000), room / (bits + Real(0.01)))));
      if (string.largest_spacing > 0) unit = std::sqrt(string.largest_spacing / Fm);
    }
  }
  template <class T, int order>
  void restore(StringState<T, order>& state) const {
    if constexpr (Vectorised<T>) {
      state.scale(to_unit_scale(larger(magnitude(state.h[0]), unit * magnitude(state.g[0]))));
    } else if constexpr (std::floating_point<T>) {
      const T size = std::max(std::abs(state.h[0]), unit * std::abs(state.g[0]));
      state.scale(std::ldexp(T(1), -std::ilogb(size)));
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
    state.pass_bead(Real(-F * string.mass[i]));
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

/// Counts changes of sign from value to value.
template <class T>
struct SignChanges {
  std::conditional_t<Vectorised<T>, T, bool> last;
  Count<T> count{};

  explicit SignChanges(const T& first) : last(sign(first)) {}
  void next(const T& value) {
    const auto now = sign(value);
    if constexpr (Vectorised<T>) {
      count -= sign_differs(last, now);
    } else {
      count += last != now ? 1 : 0;
    }
    last = now;
  }
  static auto sign(const T& value) {
    if constexpr (Vectorised<T>) {
      return value;
    } else {
      return value < 0;
    }
  }
};

/// The run from the left for several forces side by side, rescaled where the stretch is shorter than the
/// string. Real: of the string; T: of each force. Lanes of forces go along one string or along as many.
template <int order, bool rescaled, class Real, class T, std::size_t several, class Safe>
std::array<Sweep<T, order>, several> run_from_left(const StringPiece<Real>& string,
                                                   const std::array<T, several>& F, const Safe& safe) {
  const auto each = [&]<std::size_t... v>(auto make, std::index_sequence<v...>) {
    return std::array{make(v)...};
  };
  constexpr auto all = std::make_index_sequence<several>();
  auto state = each([&](std::size_t) { return StringState<T, order>(T{} + 1, T{} + string.slope); }, all);
  auto changes = each([&](std::size_t v) { return SignChanges<T>(state[v].h[0]); }, all);
  const auto push = each([&](std::size_t v) { return T(-F[v]); }, all);
  const std::size_t spacings = string.spacing.size();
  for (std::size_t i = 0; i < spacings;) {
    const std::size_t stop = rescaled ? i + std::min(safe.links, spacings - i) : spacings;
    for (; i < stop; ++i) {
      for (std::size_t v = 0; v < several; ++v) {
        state[v].pass_bead(T(push[v] * string.mass[i]));
        state[v].pass_spacing(string.spacing[i]);
        changes[v].next(state[v].h[0]);
      }
    }
    if constexpr (rescaled) {
      for (auto& one : state) safe.restore(one);
    }
  }
  return each(
      [&](std::size_t v) {
        Sweep<T, order> result;
        if (string.free_end()) {
          state[v].pass_bead(T(push[v] * string.mass.back()));
          changes[v].next(state[v].g[0]);
          for (int t = 0; t <= order; ++t) result.f[t] = std::move(state[v].g[t]);
        } else {
          for (int t = 0; t <= order; ++t) result.f[t] = std::move(state[v].h[t]);
        }
        result.below = changes[v].count;
        return result;
      },
      all);
}
/// Along one string, for several forces.
template <int order, class Real, class T, std::size_t several, class Safe>
std::array<Sweep<T, order>, several> sweep(const StringPiece<Real>& string, const std::array<T, several>& F,
                                           const Safe& safe) {
  return safe.links < string.size() ? run_from_left<order, true>(string, F, safe)
                                    : run_from_left<order, false>(string, F, safe);
}
/// Along one string, for one force.
template <int order, Floating Real>
Sweep<Real, order> sweep(const StringPiece<Real>& string, const Real& F) {
  return sweep<order>(string, std::array{F}, SafeStretch<Real>(string, F))[0];
}

/// The run from both ends in the two lanes of a register, joined at a bead in the middle: half as long.
template <int order>
Sweep<double, order> sweep_from_both_ends(const StringPiece<double>& string, double F) {
  const SafeStretch<double> safe(string, F);
  StringState<Pair, order> state(Pair{1, 1}, Pair{string.slope, string.end_slope()});
  SignChanges<Pair> changes(state.h[0]);
  std::size_t i = 0, j = string.size() - 1;
  while (i + 1 < j) {
    for (std::size_t links = std::min(safe.links, (j - i) / 2); links > 0; --links) {
      state.pass_bead(-F * Pair{string.mass[i], string.mass[j]});
      state.pass_spacing(Pair{string.spacing[i], string.spacing[j - 1]});
      changes.next(state.h[0]);
      ++i, --j;
    }
    safe.restore(state);
  }
  // At most one link is left, to the left; the mass of the bead where the runs meet counts once.
  const Pair last = i < j ? Pair{string.mass[i], string.mass[j]} : Pair{0, string.mass[j]};
  state.pass_bead(-F * last);
  state.pass_spacing(Pair{i < j ? string.spacing[i] : 0, 0});
  changes.next(state.h[0]);
  // The force that holds the halves together, times both deflections: left slope + right slope, each per
  // deflection. Where it has to push, one more critical force lies below F.
  Sweep<double, order> result{{}, static_cast<std::size_t>(changes.count[0] + changes.count[1])};
  for (int t = 0; t <= order; ++t) {
    for (int s = 0; s <= t; ++s) {
      result.f[t] += state.g[s][0] * state.h[t - s][1] + state.g[s][1] * state.h[t - s][0];
    }
  }
  result.below += (result.f[0] < 0) != ((state.h[0][0] < 0) != (state.h[0][1] < 0)) ? 1 : 0;
  return result;
}

}  // namespace plumbline::detail
