#pragma once
/// \file
/// Roots of a polynomial all of whose roots are real and positive, from its values and the number of roots
/// below a point (string_sweep.hpp): Laguerre's iteration inside brackets, and close by the inverse series.

#include <plumbline/straight/string_sweep.hpp>

namespace plumbline::detail {

/// Eighteen digits, and exponents without a limit that matters: the square of what ten thousand digits
/// resolve is far below what a long double can hold.
using WideRange = mp::number<mp::mpfr_float_backend<18, mp::allocate_stack>, mp::et_off>;

/// x / y as good as double has it, for what needs no more.
template <class T>
auto rough_ratio(const T& x, const T& y) {
  if constexpr (requires { x.backend(); }) {
    WideRange ratio;
    mpfr_div(ratio.backend().data(), x.backend().data(), y.backend().data(), MPFR_RNDN);
    return ratio;
  } else {
    return x / y;
  }
}
/// The type of a quotient to double's digits.
template <class T>
using Rough = decltype(rough_ratio(std::declval<T>(), std::declval<T>()));

/// What moves x to a root of f nearby, x (1 + size), and how far to trust it.
template <class T>
struct Step {
  T size;
  Rough<T> nearness;      ///< bound on the square of the size against the distance to other roots and to 0
  Rough<T> left, factor;  ///< left^2 factor bounds the square of the relative error that the step leaves

  /// Whether the bounds hold.
  [[nodiscard]] auto close_by() const { return nearness < 1.0 / 256; }
  template <class Enough>
  [[nodiscard]] auto settles(const Enough& enough) const {
    const Rough<T> ratio = left / enough;
    return close_by() & (ratio * ratio * factor < 1.0);
  }
};

/// The inverse series of the Taylor polynomial f of order 3 or 4 in the relative change of x. With d_i the
/// relative distances of the other roots and a = f_0 / f_1, b = f_2 / f_1, c = f_3 / f_1: b = -sum 1 / d_i
/// and b^2 - 2 c = sum 1 / d_i^2 up to the size of the step; by Newton's identities the further coefficients
/// are at most powers of m, m^2 = max(b^2, b^2 - 2 c, 1), and so the next term of the inverse series at most
/// 11 m^3 a^4, or 45 m^4 a^5.
template <class T, std::size_t terms>
[[gnu::always_inline]] inline Step<T> series_step(const std::array<T, terms>& f) {
  using R = Rough<T>;
  T a = f[0], ab = f[2];
  a /= f[1];
  const R A = rough_ratio(f[0], f[1]), B = rough_ratio(f[2], f[1]), C = rough_ratio(f[3], f[1]);
  const R squares = B * B - (C + C), nearness = larger(larger(R(B * B), squares), R(R{} + 1)) * A * A;
  R higher = (B * B + B * B - C) * A * A, left = 16 * nearness * A;
  if constexpr (terms > 4) {
    higher += (5 * B * (B * B - C) + f[4] / f[1]) * A * A * A;
    left *= 4 * nearness;
  }
  ab /= f[1];
  ab *= a;
  ab += T(higher);
  ab *= a;
  a += ab;
  return {T(-a), nearness, left, terms > 4 ? R(R{} + 1) : nearness};
}

/// Laguerre's step: from between two roots it reaches towards either, and not beyond; from below the lowest
/// towards that, from however far.
template <class T, std::size_t terms, class Upwards>
[[gnu::always_inline]] inline T laguerre_step(const std::array<T, terms>& f, double degree,
                                              const Upwards& upwards) {
  const T N = T{} + degree;
  const T root = square_root(T((N - 1) * larger(T((N - 1) * f[1] * f[1] - 2 * N * f[0] * f[2]), T{})));
  // f' / f has another sign above a root than below it
  const T towards = (f[0] < 0) == upwards ? root : T(-root);
  return -N * f[0] / (f[1] + towards);
}

/// Part of the line that holds the roots number `below` to `up_to` - 1, and where to look next.
template <Floating Real>
struct Bracket {
  Real low, high;
  std::size_t below, up_to;
  Real next;
  Real last = Real(1);  ///< the step that led there, relative; 1 when it was none

  [[nodiscard]] bool single() const { return up_to - below == 1; }
  /// Looks next in the middle, in the measure of a graded spectrum. False when there is no number between.
  bool halve() {
    using std::sqrt;
    next = sqrt(low) * sqrt(high);
    last = Real(1);
    return low < next && next < high;
  }
};

/// Shortens the bracket of a single root by what was found at its next point, and steps on. Returns true when
/// the root is known: when the series says so, and leads the way that the count points.
template <Floating Real>
bool close_in(Bracket<Real>& bracket, const Sweep<Real, 3>& at, std::size_t degree) {
  using std::abs;
  using std::sqrt;
  const Real x = bracket.next;
  if (at.below > bracket.up_to) {  // there were more roots than one
    bracket.high = x;
    return !bracket.halve();
  }
  if (at.f[0] == 0) return true;
  const bool upwards = at.below <= bracket.below;
  const auto series = series_step(at.f);
  const bool close_by = series.close_by() && (series.size > 0) == upwards;
  const bool done = close_by && series.settles(rough_ratio(epsilon<Real>(), Real(8)));
  const Real step = close_by ? series.size : laguerre_step(at.f, static_cast<double>(degree), upwards);
  const Real target = x + x * step, size = abs(step);
  if (!done) {
    const Real width = close_by ? Real(1) : Real(bracket.high / bracket.low);
    (upwards ? bracket.low : bracket.high) = x;
    const bool slow = !close_by && bracket.high > bracket.low * sqrt(width) && size > bracket.last / 2;
    if (slow || !(bracket.low < target && target < bracket.high)) return !bracket.halve();
  }
  bracket.next = target;
  bracket.last = size;
  return done;
}

/// Bounds on all critical forces of a string. The lower: the sum of their reciprocals is the sum over the
/// beads of mass times compliance, and no bead is more compliant than all the spacings on a fixed side of it.
/// The upper: the stiffness matrix of a string is at most twice its diagonal.
template <Floating Real>
Bracket<Real> all_of(const StringPiece<Real>& string) {
  Real left = string.slope, high(0), mass(0), reach(0);
  for (std::size_t i = 0; i < string.size(); ++i) {
    const bool fixed = i < string.spacing.size();
    const Real right = fixed ? Real(Real(1) / string.spacing[i]) : Real(0);
    high = std::max(high, Real((left + right) / string.mass[i]));
    mass += string.mass[i];
    if (fixed) reach += string.spacing[i];
    left = right;
  }
  if (string.free_end()) reach += Real(1) / string.slope;
  Bracket<Real> all{Real(1) / (Real(2) * mass * reach), Real(4) * high, 0, string.size(), Real(0)};
  all.halve();
  return all;
}

}  // namespace plumbline::detail
