#pragma once
/// \file
/// Mode shapes of the straight chain at its critical forces, to high relative accuracy in each component: the
/// string with beads (bead_string.hpp) is run from both ends, and the two runs are joined at the bead where
/// they fit best (a twisted factorisation).

#include <limits>
#include <plumbline/critical_force.hpp>

namespace plumbline {

/// Deflection of each bead and slope of the string before it, run from one end. The true values are the
/// stored ones times 2^exponent.
template <Floating Real>
struct StringRun {
  std::vector<Real> deflection, slope;
  std::vector<int> exponent;
};

/// From the left: bead i with the slope before it.
template <Floating Real>
StringRun<Real> run_rightwards(const BeadString<Real>& string, const Real& F) {
  StringRun<Real> run;
  Real h[1] = {Real(1)}, g[1] = {string.slope};
  int exponent = 0;
  for (std::size_t i = 0; i < string.size(); ++i) {
    run.deflection.push_back(h[0]);
    run.slope.push_back(g[0]);
    run.exponent.push_back(exponent);
    g[0] -= F * string.mass[i] * h[0];
    if (i < string.spacing.size()) h[0] += string.spacing[i] * g[0];
    exponent -= keep_in_range(h, g);
  }
  return run;
}

/// From the right: bead i with the slope behind it.
template <Floating Real>
StringRun<Real> run_leftwards(const BeadString<Real>& string, const Real& F) {
  StringRun<Real> run;
  const bool free_end = string.spacing.size() < string.size();
  Real h[1] = {Real(1)}, g[1] = {free_end ? Real(0) : Real(Real(-1) / string.spacing.back())};
  int exponent = 0;
  for (std::size_t i = string.size(); i-- > 0;) {
    run.deflection.push_back(h[0]);
    run.slope.push_back(g[0]);
    run.exponent.push_back(exponent);
    g[0] += F * string.mass[i] * h[0];
    if (i > 0) h[0] -= string.spacing[i - 1] * g[0];
    exponent -= keep_in_range(h, g);
  }
  std::reverse(run.deflection.begin(), run.deflection.end());
  std::reverse(run.slope.begin(), run.slope.end());
  std::reverse(run.exponent.begin(), run.exponent.end());
  return run;
}

/// The bead at which the force that holds the two runs together, over the bead's mass, is smallest.
template <Floating Real>
std::size_t best_joint(const BeadString<Real>& string, const Real& F, const StringRun<Real>& left,
                       const StringRun<Real>& right) {
  using std::abs;
  std::size_t best = 0;
  Real least(-1);
  for (std::size_t i = 0; i < string.size(); ++i) {
    if (left.deflection[i] == Real(0) || right.deflection[i] == Real(0)) continue;
    const Real force = left.slope[i] / left.deflection[i] - right.slope[i] / right.deflection[i];
    const Real misfit = abs(force / string.mass[i] - F);
    if (least < Real(0) || misfit < least) {
      least = misfit;
      best = i;
    }
  }
  return best;
}

/// The shape of one string's mode as joint angles of the whole chain; the rest of the chain is straight.
template <Floating Real>
std::vector<Real> joint_angles(const Chain<Real>& chain, const BeadString<Real>& string, const Real& F) {
  using std::ldexp;
  const std::vector<Real> z = distance_to_end(chain);
  const auto left = run_rightwards(string, F), right = run_leftwards(string, F);
  const std::size_t joint = best_joint(string, F, left, right);
  const auto joined = [&](const StringRun<Real>& run, const std::vector<Real>& values, std::size_t i) {
    return ldexp(Real(values[i] / run.deflection[joint]), run.exponent[i] - run.exponent[joint]);
  };
  std::vector<Real> q(chain.size(), Real(0));
  const auto bend = [&](std::size_t i, const Real& slope) {
    if (!chain.passive_joint(i)) q[i] = z[i] / chain.stiffness()[i] * slope;
  };
  for (std::size_t i = 0; i <= joint; ++i) bend(string.first + i, joined(left, left.slope, i));
  for (std::size_t i = joint; i < string.size(); ++i)
    bend(string.first + i + 1, joined(right, right.slope, i));
  // A passive joint turns by the jump of the deflection between its two sides, one of which is straight.
  const std::size_t end = string.first + string.size();
  if (chain.passive_joint(string.first)) q[string.first] = joined(left, left.deflection, 0) / z[string.first];
  if (chain.passive_joint(end)) q[end] = -joined(right, right.deflection, string.size() - 1) / z[end];
  return q;
}

/// Mode of one string: (q, F_y) of norm 1, the first joint that turns at all turns to the positive side.
/// Since S_0^T q = 0 (30), the first equation of (29) is F_y = -k_1 q_1 / z_1.
template <Floating Real>
Mode<Real> mode_of(const Chain<Real>& chain, const BeadString<Real>& string, const Real& force) {
  using std::abs;
  using std::sqrt;
  std::vector<Real> q = joint_angles(chain, string, force);
  Real fy = -(chain.stiffness()[0] / distance_to_end(chain)[0] * q[0]);
  Real largest = abs(fy), squares(0);
  for (const Real& angle : q) largest = std::max(largest, Real(abs(angle)));
  for (const Real& angle : q) squares += (angle / largest) * (angle / largest);
  squares += (fy / largest) * (fy / largest);
  const auto first = std::find_if(q.begin(), q.end(), [](const Real& angle) { return angle != Real(0); });
  const Real scale = largest * sqrt(squares) * (*first < Real(0) ? Real(-1) : Real(1));
  for (Real& angle : q) angle /= scale;
  return {force, std::move(q), Real(fy / scale)};
}

/// The shape at a critical force that critical_forces() gave. Where two parts of a chain with an interior
/// passive joint share that force, the shape of the first part; critical_modes() gives both.
/// \throws Error for n = 1 or a mechanism
template <Floating Real>
Mode<Real> buckling_mode(const Chain<Real>& chain, const Real& force) {
  const auto strings = bead_strings(chain);
  const auto step = [&](const BeadString<Real>& string) {  // Newton's, from the force to the string's own
    using std::abs;
    const auto at = sweep<1>(string, force);
    return at.h[1] == Real(0) ? std::numeric_limits<Real>::infinity() : Real(abs(at.h[0] / at.h[1]));
  };
  const auto& own = strings.size() == 1 || step(strings[0]) <= step(strings[1]) ? strings[0] : strings[1];
  return mode_of(chain, own, force);
}

/// The lowest critical forces with their shapes, ascending: `lowest` of them, or all n - 1. Critical forces
/// that tie across an interior passive joint come with independent shapes.
/// \throws Error for n = 1 or a mechanism
template <Floating Real>
std::vector<Mode<Real>> critical_modes(const Chain<Real>& chain, std::size_t lowest) {
  std::vector<Mode<Real>> modes;
  for (const auto& string : bead_strings(chain)) {
    for (const Real& force : critical_forces(string, lowest)) modes.push_back(mode_of(chain, string, force));
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const auto& a, const auto& b) { return a.force < b.force; });
  modes.resize(std::min(lowest, modes.size()));
  return modes;
}

}  // namespace plumbline
