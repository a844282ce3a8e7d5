#pragma once
/// \file
/// The lowest critical force of a string. A short one takes three runs along it; of a long one a coarser
/// string, eight beads drawn together to one, and so on down to a few beads, says where to begin, and one or
/// two runs are enough.

#include <optional>
#include <plumbline/base/widest.hpp>
#include <plumbline/straight/laguerre.hpp>

namespace plumbline::detail {

/// A string with an eighth of the beads: each group's mass in its centre, which keeps mass, first moment and
/// length, and so the lowest frequency to second order in the size of a group.
class CoarseString {
 public:
  explicit CoarseString(const StringPiece<double>& fine)
      : mass_((fine.size() + group - 1) / group), spacing_(mass_.size()) {
    double before = 0;  // from the support or the last group's centre to this group's first bead
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      const std::size_t first = i * group, end = std::min(first + group, fine.size());
      double mass = 0, moment = 0, behind = 0;
      for (std::size_t bead = end; bead-- > first;) {
        if (bead < fine.spacing.size()) behind += fine.spacing[bead];
        mass += fine.mass[bead];
        moment += fine.mass[bead] * behind;
      }
      const double to_next = moment / mass, from_first = behind - to_next;
      (i == 0 ? lead_ : spacing_[i - 1]) = before + from_first;
      mass_[i] = mass;
      before = to_next;
    }
    spacing_[spacing_.size() - 1] = before;
    largest_mass_ = group * fine.largest_mass;
    largest_spacing_ = 2 * group * fine.largest_spacing;
    slope_ = fine.slope > 0 ? 1 / (1 / fine.slope + lead_) : 0;
    free_end_ = fine.free_end();
  }
  [[nodiscard]] StringPiece<double> piece() const {
    return {0,
            {mass_.begin(), mass_.size()},
            {spacing_.begin(), mass_.size() - (free_end_ ? 1 : 0)},
            slope_,
            largest_mass_,
            largest_spacing_};
  }

 private:
  static constexpr std::size_t group = 8;
  Scratch<double> mass_, spacing_;
  double lead_{0}, slope_, largest_mass_, largest_spacing_;
  bool free_end_;
};

/// Near the lowest root, and mostly below it: Laguerre's step from F = 0, which is, and from there to the
/// root of the Taylor polynomial of order 5 at F = 0, which is, too, for the terms alternate. With T = Lanes,
/// in each lane.
template <class T>
[[gnu::always_inline]] inline T close_to_lowest(const StringPiece<T>& string) {
  constexpr int order = 5;
  T h[order + 1] = {T{} + 1}, g[order + 1] = {string.slope};
  for (int t = 1; t <= order; ++t) h[t] = g[t] = T{};
  const auto pass_bead = [&](const T& mass) {
    for (int t = order; t > 0; --t) g[t] -= mass * h[t - 1];
  };
  for (std::size_t i = 0; i < string.spacing.size(); ++i) {
    pass_bead(string.mass[i]);
    for (int t = 0; t <= order; ++t) h[t] += string.spacing[i] * g[t];
  }
  if (string.free_end()) pass_bead(string.mass.back());
  std::array<T, order + 1> f;
  for (int t = 0; t <= order; ++t) f[t] = string.free_end() ? g[t] : h[t];
  const T x = laguerre_step(f, static_cast<double>(string.size()), T{} == 0);
  T power = x;
  for (int t = 1; t <= order; ++t) {
    f[t] *= power;
    power *= x;
  }
  for (int t = 0; t < 4; ++t) {  // now about x, in its relative change
    for (int i = order - 1; i >= t; --i) f[i] += f[i + 1];
  }
  const auto series = series_step<T, 4>({f[0], f[1], f[2], f[3]});
  return series.close_by() ? x + x * series.size : x;
}

/// The lowest root, from near it or from below; NaN where a few runs do not reach it or it is another one.
template <class T, class Run>
T lowest_root(const Run& run, T x, double degree, double enough) {
  auto open = T{} == 0;
  for (int runs = 0; any(open) && runs < 12; ++runs) {
    const auto at = run(x);
    const auto series = series_step(at.f);
    const auto close_by = series.close_by() & (at.below <= 1);
    T step = series.size;
    if (any(open & (close_by == 0))) step = close_by ? step : laguerre_step(at.f, degree, at.below == 0);
    x = open ? x + x * step : x;
    open &= (close_by & series.settles(enough)) == 0;
  }
  return open ? T{} + std::numeric_limits<double>::quiet_NaN() : x;
}

/// The one root in a bracket.
template <Floating Real>
Real root_in(const StringPiece<Real>& string, Bracket<Real> bracket) {
  while (!close_in(bracket, sweep<3>(string, bracket.next), string.size())) {
  }
  return bracket.next;
}

/// The lowest critical force of a string, to a relative error that is enough.
inline double lowest_force(const StringPiece<double>& string,
                           double enough = std::numeric_limits<double>::epsilon() / 8) {
  const auto degree = static_cast<double>(string.size());
  double force = 0;
  if (string.size() > 32) {
    const CoarseString coarse(string);
    const double near = lowest_force(coarse.piece(), 1e-6);
    const auto run = [&](double F) { return in_widest([&] { return sweep_from_both_ends<4>(string, F); }); };
    force = lowest_root(run, near, degree, enough);
  } else {
    force =
        lowest_root([&](double F) { return sweep<3>(string, F); }, close_to_lowest(string), degree, enough);
  }
  if (!std::isnan(force)) return force;
  Bracket<double> bracket = all_of(string);
  bracket.up_to = 1;
  bracket.next = bracket.low;
  bracket.last = std::numeric_limits<double>::infinity();  // the first step may be as long as it likes
  return root_in(string, bracket);
}

}  // namespace plumbline::detail
