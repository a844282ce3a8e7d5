#pragma once
/// \file
/// Roots of a polynomial all of whose roots are real and positive, from its values and the number of roots
/// below a point (string_sweep.hpp): Laguerre's iteration inside brackets.

#include <plumbline/string_sweep.hpp>

namespace plumbline {

/// Laguerre's step e from x towards a root, x (1 - e) being the next iterate. From between two roots it
/// reaches towards either, and not beyond. \param f  value and Taylor coefficients in the relative change of
/// x \return e, and the sum over all roots of 1 / (relative distance)^2
template <class T>
std::pair<T, T> laguerre_step(const T (&f)[3], double degree, bool upwards) {
  using std::sqrt;
  const T N(degree);
  const T G = f[1] / f[0], half = f[2] / f[0];
  const T H = G * G - (half + half);
  const T spread = (N - T(1)) * (N * H - G * G);
  const T root = spread > T(0) ? T(sqrt(spread)) : T(0);
  return {N / (upwards ? T(G - root) : T(G + root)), H};
}

/// A root, and what the others near it do to the convergence: a small error e leaves less than rate e^3.
template <Floating Real>
struct Root {
  Real value, rate;
};

/// Part of the line that holds the roots number `below` to `up_to` - 1, and where to look next.
template <Floating Real>
struct Bracket {
  Real low, high;
  std::size_t below, up_to;
  Real next;
  Real rate;            ///< of convergence, as for Root, before a step has told
  Real last = Real(1);  ///< the step that led there, relative; 1 when it was no Laguerre step
  Real enough = epsilon<Real>() / Real(8);  ///< relative error that will do
  Real pull = Real(0);  ///< the sum over all roots of 1 / (relative distance)^2 where that step was made

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
/// the root is known. For that Newton's step must be nearly the same, so that it is this root that is near
/// and not one behind, and the error that the step leaves small enough. With d the relative distances of
/// the other roots that error is less than e^3 / 2 sum 1 / d^2; the last two steps tell the sum.
template <Floating Real>
bool close_in(Bracket<Real>& bracket, const Sweep<Real, 2>& at, std::size_t degree) {
  using std::abs;
  using std::sqrt;
  const Real x = bracket.next;
  if (at.below > bracket.up_to) {  // there were more roots than one
    bracket.high = x;
    return !bracket.halve();
  }
  if (at.f[0] == Real(0)) return true;
  const bool upwards = at.below <= bracket.below;
  const Real width = bracket.high / bracket.low;
  (upwards ? bracket.low : bracket.high) = x;
  const auto [signed_step, pull] = laguerre_step(at.f, static_cast<double>(degree), upwards);
  const Real step = abs(signed_step), target = x - x * signed_step;
  const Real others = abs(Real(at.f[1] / at.f[0] * signed_step - Real(1)));  // e sum 1 / d
  if (bracket.last < Real(0.1)) {
    const Real before = bracket.last + step;
    bracket.rate = std::max(Real(1), Real(Real(4) * abs(Real(bracket.pull - Real(1) / (before * before)))));
  }
  const Real left = std::max(Real(bracket.rate * step * step), Real(others * others)) * step;
  const bool done = others < Real(0.1) && left < bracket.enough;
  const bool slow = bracket.high > bracket.low * sqrt(width) && step > bracket.last / Real(2);
  if (!done && (slow || !(bracket.low < target && target < bracket.high))) return !bracket.halve();
  bracket.next = target;
  bracket.last = step;
  bracket.pull = pull;
  return done;
}

/// Bounds on all critical forces of a string. The lower: the sum of their reciprocals is the sum over the
/// beads of mass times compliance, and no bead is more compliant than all the spacings on a fixed side of it.
/// The upper: the stiffness matrix of a string is at most twice its diagonal.
template <Floating Real>
Bracket<Real> all_of(const StringPiece<Real>& string) {
  const auto degree = static_cast<double>(string.size());
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
  Bracket<Real> all{Real(1) / (Real(2) * mass * reach), Real(4) * high, 0, string.size(), Real(0),
                    Real(1000 + degree * degree)};  // roots as close as this many are when they are even
  all.halve();
  return all;
}

}  // namespace plumbline
