#pragma once
/// \file
/// Critical forces of the straight chain and their mode shapes, in O(n) each, to high relative accuracy: they
/// are the roots of the last deflection of a string with beads (bead_string.hpp), and the number of sign
/// changes on the way counts those below F. Rounding perturbs each datum only relatively.

#include <plumbline/bead_string.hpp>
#include <plumbline/mode.hpp>

namespace plumbline {

/// The number of critical forces below F, each as often as it occurs.
/// \throws Error for n = 1 or a mechanism
template <Ordered Real>
std::size_t count_below(const Chain<Real>& chain, const Real& F) {
  std::size_t count = 0;
  for (const auto& string : bead_strings(chain)) count += sweep<0>(string, F).count;
  return count;
}

/// Laguerre's step e from x towards a root, x (1 - e) being the next iterate. From between two roots of a
/// polynomial of this degree, all of whose roots are real, it reaches towards either and not beyond.
template <Floating Real>
Real laguerre_step(const Real (&h)[3], std::size_t degree, bool upwards) {
  using std::sqrt;
  const Real N(static_cast<double>(degree));
  const Real G = h[1] / h[0];
  const Real H = G * G - Real(2) * h[2] / h[0];
  const Real spread = (N - Real(1)) * (N * H - G * G);
  const Real root = spread > Real(0) ? Real(sqrt(spread)) : Real(0);
  return N / (upwards ? Real(G - root) : Real(G + root));
}

/// Part of the line that holds the roots number `below` to `up_to` - 1 of a string.
template <Floating Real>
struct Bracket {
  Real low, high;
  std::size_t below, up_to;
};

/// Bounds on all critical forces of a string. The lower: the sum of their reciprocals is the sum over the
/// beads of mass times compliance, and no bead is more compliant than all spacings in a row. The upper: the
/// stiffness matrix of a string is at most twice its diagonal.
template <Floating Real>
Bracket<Real> all_of(const BeadString<Real>& string) {
  const bool free_end = string.spacing.size() < string.size();
  Real left = string.slope, high(0), mass(0), reach(0);
  for (std::size_t i = 0; i < string.size(); ++i) {
    const Real right = i < string.spacing.size() ? Real(Real(1) / string.spacing[i]) : Real(0);
    high = std::max(high, Real((left + right) / string.mass[i]));
    mass += string.mass[i];
    if (i < string.spacing.size()) reach += string.spacing[i];
    left = right;
  }
  // A bead sees both ends in parallel; a free end does not help.
  if (free_end) reach += Real(1) / string.slope;
  return {Real(1) / (Real(2) * mass * reach), Real(4) * high, 0, string.size()};
}

/// The one root in a bracket. Convergence is cubic: a step e after a small step e' leaves C e^3 with
/// C = e / e'^3, which is trusted no further down than 1.
template <Floating Real>
Real root_in(const BeadString<Real>& string, Bracket<Real> bracket, Real x) {
  using std::abs;
  using std::sqrt;
  const Real u = epsilon<Real>();
  Real last(1);
  while (bracket.high > bracket.low * (Real(1) + u)) {
    const auto at = sweep<2>(string, x);
    if (at.h[0] == Real(0)) return x;
    const bool upwards = at.count == bracket.below;
    const Real width = bracket.high / bracket.low;
    (upwards ? bracket.low : bracket.high) = x;
    const Real step = abs(laguerre_step(at.h, string.size(), upwards));
    const Real next = upwards ? Real(x * (Real(1) + step)) : Real(x * (Real(1) - step));
    const Real C = last < Real(0.1) ? std::max(Real(1), Real(step / (last * last * last))) : Real(1000);
    if (step < u || C * step * step * step < u / Real(8)) return next;
    const bool slow = bracket.high / bracket.low > sqrt(width) && step > last / Real(2);
    const bool inside = bracket.low < next && next < bracket.high;
    x = inside && !slow ? next : Real(sqrt(bracket.low) * sqrt(bracket.high));
    last = inside && !slow ? step : Real(1);
  }
  return bracket.high;
}

/// Appends the roots in a bracket, from below, until there are `wanted` of them.
template <Floating Real>
void append_roots(const BeadString<Real>& string, const Bracket<Real>& bracket, std::size_t wanted,
                  std::vector<Real>& roots) {
  using std::sqrt;
  if (bracket.below == bracket.up_to || bracket.below >= wanted) return;
  const Real middle = sqrt(bracket.low) * sqrt(bracket.high);
  if (!(bracket.low < middle && middle < bracket.high)) {  // a tie, to the last digit
    roots.insert(roots.end(), std::min(wanted, bracket.up_to) - bracket.below, bracket.high);
  } else if (bracket.up_to - bracket.below == 1) {
    roots.push_back(root_in(string, bracket, middle));
  } else {
    const std::size_t count =
        std::clamp(sweep<0>(string, middle).count, bracket.below, bracket.up_to);  // whatever rounding does
    append_roots(string, {bracket.low, middle, bracket.below, count}, wanted, roots);
    append_roots(string, {middle, bracket.high, count, bracket.up_to}, wanted, roots);
  }
}

/// The lowest critical forces of one string, ascending.
template <Floating Real>
std::vector<Real> critical_forces(const BeadString<Real>& string, std::size_t lowest) {
  std::vector<Real> forces;
  append_roots(string, all_of(string), lowest, forces);
  return forces;
}

/// The lowest critical forces, ascending, each as often as it occurs: `lowest` of them, or all n - 1 when
/// there are not more. Relative error of a few n units in the last place, whatever the grading.
/// \throws Error for n = 1 or a mechanism
template <Floating Real>
std::vector<Real> critical_forces(const Chain<Real>& chain, std::size_t lowest) {
  std::vector<Real> forces;
  for (const auto& string : bead_strings(chain)) {
    const std::vector<Real> more = critical_forces(string, lowest);
    const auto middle = forces.insert(forces.end(), more.begin(), more.end());
    std::inplace_merge(forces.begin(), middle, forces.end());
  }
  forces.resize(std::min(lowest, forces.size()));
  return forces;
}

}  // namespace plumbline
