#pragma once
/// \file
/// What a stretch of rod hands on from one end to the other, by power series with a proved remainder.
///
/// In units of the rod's length and E I, w'''' + (N w')' + q w' + b w = 0 with N = N_0 + N_1 x. On a stretch
/// of length l, w = Σ α_k t^k, t = x / l, has with n_0 = N_0 l², n_1 = N_1 l³, p = q l³, β = b l⁴
///
///     (k+1)(k+2)(k+3)(k+4) α_{k+4} = -(k+1)(k+2) n_0 α_{k+2} - (k+1) ((k+1) n_1 + p) α_{k+1} - β α_k .
///
/// With q = (|n_0| + |n_1| + |p|) / ((K-1) K) + |β| / ((K-3) (K-2) (K-1) K) <= 1/16 the coefficients K … K+3
/// are at most q times the largest of the four before them, and so on, while k³ grows at most eightfold: Σ k³
/// |α_k| from K on is at most 8 (K + 3)³ q times that largest one. Numbers are intervals, or functions of two
/// variables (expansion.hpp), whose absolute value is a norm.

#include <array>

#include "proofs/rod/expansion.hpp"

namespace plumbline::proofs {

/// (w, θ = w', M = w'', V = w''' + N w'): continuous but where something holds the rod or acts on it. V is
/// the force across.
template <class Real>
using RodState = std::array<Real, 4>;

/// N_0, N_1, q and b of a stretch.
template <class Real>
struct RodEquation {
  Real compression, slope, tangential, bed;
};

/// The state at the end of a stretch from that at its beginning.
/// \param length  in that of the rod, at most 1
/// \throws Error where the series does not converge in a thousand terms
template <class Real>
RodState<Real> carried(const RodState<Real>& state, const Rational& length,
                       const RodEquation<Real>& equation) {
  const auto scaled = [&](const Real& x, const Rational& by) { return x * Interval(by); };
  const Rational l2 = length * length, l3 = l2 * length;
  const Real n0 = scaled(equation.compression, l2), n1 = scaled(equation.slope, l3),
             p = scaled(equation.tangential, l3), beta = scaled(equation.bed, l2 * l2);
  const double load = size_of(n0) + size_of(n1) + size_of(p), bed = size_of(beta);
  std::array<Real, 4> last{state[0], scaled(state[1], length), scaled(state[2], l2 / 2),
                           scaled(state[3], l3 / 6) - scaled(n0 * state[1], length / 6)};
  std::array<Real, 4> sum{last[0] + last[1] + last[2] + last[3],
                          last[1] + last[2] * Interval(2) + last[3] * Interval(3),
                          last[2] * Interval(2) + last[3] * Interval(6), last[3] * Interval(6)};
  double rest = 0;
  for (int k = 0;; ++k) {
    const double K = k + 4, q = (load + bed / ((K - 3) * (K - 2))) / ((K - 1) * K);
    if (q <= 1.0 / 16) {
      double largest = 0;
      for (const Real& alpha : last) largest = std::max(largest, size_of(alpha));
      rest = 8 * (K + 3) * (K + 3) * (K + 3) * q * largest * (1 + 1e-12);  // the latter for rounding
      if (rest < 1e-60) break;
    }
    if (k > 1000) throw Error("rod", "a stretch too long for its load or bed", "a shorter or stiffer one");
    const Interval both(Rational(1, (k + 3) * (k + 4)));
    const Real next = -((n0 * last[2] + (n1 * Interval(k + 1) + p) * last[1] * Interval(Rational(1, k + 2)) +
                         beta * last[0] * Interval(Rational(1, (k + 1) * (k + 2)))) *
                        both);
    last = {last[1], last[2], last[3], next};
    Real term = next;
    for (int d = 0; d < 4; ++d) {
      sum[static_cast<std::size_t>(d)] += term;
      term = term * Interval(k + 4 - d);
    }
  }
  for (Real& each : sum) add_remainder(each, rest);
  const Real slope = scaled(sum[1], 1 / length);
  return {sum[0], slope, scaled(sum[2], 1 / l2),
          scaled(sum[3], 1 / l3) + (equation.compression + scaled(equation.slope, length)) * slope};
}

}  // namespace plumbline::proofs
