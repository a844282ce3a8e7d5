#pragma once
/// \file
/// Mode shapes of the straight chain at its critical forces, to high relative accuracy in each component: the
/// string with beads (bead_string.hpp) is run from both ends, and the two runs are joined at the bead where
/// they fit best (a twisted factorisation).
///
/// \code{.cpp}
/// const Chain<double> chain({1, 1, 1, 1}, {1, 1, 1, 1});
/// const std::vector<Mode<double>> modes = critical_modes(chain, 3);
/// assert(shape_name(sign_pattern(modes[0].q)) == "U" && shape_name(sign_pattern(modes[2].q)) == "Z");
/// \endcode

#include <limits>
#include <plumbline/straight/critical_force.hpp>

namespace plumbline {

namespace detail {

/// Deflection of each bead and slope of the string before it, run from one end. The true values are the
/// stored ones times 2^exponent.
template <Floating Real>
struct StringRun {
  std::vector<Real> deflection, slope;
  std::vector<int> exponent;

  void keep(const StringState<Real, 0>& state) {
    deflection.push_back(state.h[0]);
    slope.push_back(state.g[0]);
    exponent.push_back(scale_);
  }
  /// Binary exponents of MPFR do not run out; those of the machine's types are kept apart.
  void restore(StringState<Real, 0>& state) {
    if constexpr (std::floating_point<Real>) {
      const int shift = std::ilogb(std::max(std::abs(state.h[0]), std::abs(state.g[0])));
      state.scale(std::ldexp(Real(1), -shift));
      scale_ += shift;
    }
  }

 private:
  int scale_ = 0;
};

/// From the left: bead i with the slope before it.
template <Floating Real>
StringRun<Real> run_rightwards(const StringPiece<Real>& string, const Real& F) {
  StringRun<Real> run;
  StringState<Real, 0> state(Real(1), string.slope);
  for (std::size_t i = 0; i < string.size(); ++i) {
    run.keep(state);
    state.pass_bead(Real(-F * string.mass[i]));
    if (i < string.spacing.size()) state.pass_spacing(string.spacing[i]);
    run.restore(state);
  }
  return run;
}

/// From the right: bead i with the slope behind it, positive when the string falls.
template <Floating Real>
StringRun<Real> run_leftwards(const StringPiece<Real>& string, const Real& F) {
  StringRun<Real> run;
  StringState<Real, 0> state(Real(1), string.end_slope());
  for (std::size_t i = string.size(); i-- > 0;) {
    run.keep(state);
    state.pass_bead(Real(-F * string.mass[i]));
    if (i > 0) state.pass_spacing(string.spacing[i - 1]);
    run.restore(state);
  }
  std::reverse(run.deflection.begin(), run.deflection.end());
  std::reverse(run.slope.begin(), run.slope.end());
  std::reverse(run.exponent.begin(), run.exponent.end());
  return run;
}

/// The bead at which the force that holds the two runs together, over the bead's mass, is smallest.
template <Floating Real>
std::size_t best_joint(const StringPiece<Real>& string, const Real& F, const StringRun<Real>& left,
                       const StringRun<Real>& right) {
  using std::abs;
  std::size_t best = 0;
  Real least(-1);
  for (std::size_t i = 0; i < string.size(); ++i) {
    if (left.deflection[i] == Real(0) || right.deflection[i] == Real(0)) continue;
    const Real force = left.slope[i] / left.deflection[i] + right.slope[i] / right.deflection[i];
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
std::vector<Real> joint_angles(const StraightChain<Real>& straight, const StringPiece<Real>& string,
                               const Real& F) {
  using std::ldexp;
  const Chain<Real>& chain = straight.chain;
  const std::vector<Real> z = straight.arms();
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
    bend(string.first + i + 1, -joined(right, right.slope, i));
  // A passive joint turns by the jump of the deflection between its two sides, one of which is straight.
  const std::size_t end = string.first + string.size();
  if (chain.passive_joint(string.first)) q[string.first] = joined(left, left.deflection, 0) / z[string.first];
  if (chain.passive_joint(end)) q[end] = -joined(right, right.deflection, string.size() - 1) / z[end];
  return q;
}

/// Mode of one string: (q, F_y) of norm 1, the first joint that turns at all turns to the positive side.
/// Since S_0^T q = 0 (30), the first equation of (29) is F_y = -k_1 q_1 / z_1; nothing holds a free end
/// point across.
template <Floating Real>
Mode<Real> mode_of(const StraightChain<Real>& straight, const StringPiece<Real>& string, const Real& force) {
  using std::abs;
  using std::sqrt;
  const Chain<Real>& chain = straight.chain;
  std::vector<Real> q = joint_angles(straight, string, force);
  Real fy(0);
  if (straight.end_point == EndPoint::guided) fy = -(chain.stiffness()[0] / distance_to_end(chain)[0] * q[0]);
  Real largest = abs(fy), squares(0);
  for (const Real& angle : q) largest = std::max(largest, Real(abs(angle)));
  for (const Real& angle : q) squares += (angle / largest) * (angle / largest);
  squares += (fy / largest) * (fy / largest);
  const auto first = std::find_if(q.begin(), q.end(), [](const Real& angle) { return angle != Real(0); });
  const Real scale = largest * sqrt(squares) * (*first < Real(0) ? Real(-1) : Real(1));
  for (Real& angle : q) angle /= scale;
  return {force, std::move(q), Real(fy / scale)};
}

/// Rounded; the force as force_in_double() has it.
inline Mode<double> in_double(const Mode<long double>& mode) {
  return {force_in_double(mode.force), {mode.q.begin(), mode.q.end()}, static_cast<double>(mode.fy)};
}

}  // namespace detail

/// The shape at a critical force that critical_forces() gave. Where two parts of a chain with an interior
/// passive joint share that force, the shape of the first part; critical_modes() gives both. An angle is as
/// accurate as the force lets it be: relative errors of the force count as many times as the reciprocal of
/// the relative distance to the next force.
/// \throws Error for n = 1 or a mechanism
template <Floating Real>
Mode<Real> buckling_mode(const Chain<Real>& chain, const Real& force) {
  const detail::BeadString<Real> string(chain);
  if constexpr (std::same_as<Real, double>) {
    if (!string.in_range())
      return detail::in_double(buckling_mode(detail::widened(chain), static_cast<long double>(force)));
  }
  const auto pieces = string.pieces();
  const auto newton = [&](const detail::StringPiece<Real>& piece) {
    using std::abs;
    const auto at = detail::sweep<1>(piece, force);
    return Real(abs(at.f[0] / at.f[1]));
  };
  const bool second = pieces.size() > 1 && newton(pieces[1]) < newton(pieces[0]);
  return detail::mode_of(StraightChain<Real>(chain), pieces[second ? 1 : 0], force);
}

/// The lowest critical forces with their shapes, ascending: `lowest` of them, or all n - 1. Critical forces
/// that tie across an interior passive joint come with independent shapes.
/// \throws Error for n = 1 or a mechanism
template <Floating Real>
std::vector<Mode<Real>> critical_modes(const StraightChain<Real>& chain, std::size_t lowest) {
  const detail::BeadString<Real> string(chain);
  std::vector<Mode<Real>> modes;
  if constexpr (std::same_as<Real, double>) {
    if (!string.in_range()) {
      const Chain<long double> wide = detail::widened(chain.chain);
      for (const auto& mode : critical_modes(StraightChain<long double>(wide, chain.end_point), lowest))
        modes.push_back(detail::in_double(mode));
      return modes;
    }
  }
  const auto roots = detail::lowest_roots(chain, lowest);
  const auto pieces = string.pieces();
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (const auto& root : roots[p]) modes.push_back(detail::mode_of(chain, pieces[p], root));
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const auto& a, const auto& b) { return a.force < b.force; });
  modes.resize(std::min(lowest, modes.size()));
  return modes;
}
/// The same with the end point guided.
template <Floating Real>
std::vector<Mode<Real>> critical_modes(const Chain<Real>& chain, std::size_t lowest) {
  return critical_modes(StraightChain<Real>(chain), lowest);
}

}  // namespace plumbline
