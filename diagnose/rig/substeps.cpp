#include "diagnose/rig/substeps.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// Whether slip is followed between readings. A free torque law knows only the history at the readings, and
/// friction by the speed of the step before would oscillate.
bool slips_on_the_way(const Layout& layout, const Rig& rig) {
  const bool slips = layout.sliders > 0 || std::isfinite(rig.yield);
  return slips && rig.laws.empty() && rig.friction_law.fall == 0;
}

}  // namespace

std::vector<std::size_t> substeps(const Run& run, const Layout& layout, const Rig& rig) {
  constexpr double least = 48;  // substeps to the farthest command
  std::vector<std::size_t> all(run.readings.size(), 1);
  if (!slips_on_the_way(layout, rig) || all.empty()) return all;
  const Eigen::Vector2d start = run.command(run.readings.front());
  double farthest = 0;
  for (const Reading& one : run.readings)
    if (const double way = (run.command(one) - start).norm(); std::isfinite(way))
      farthest = std::max(farthest, way);
  Eigen::Vector2d last = start;
  for (std::size_t r = 0; r < all.size() && farthest > 0; ++r) {
    const Eigen::Vector2d here = run.command(run.readings[r]);
    if (!here.allFinite()) continue;
    all[r] = static_cast<std::size_t>(std::max(1.0, std::ceil(least * (here - last).norm() / farthest)));
    last = here;
  }
  return all;
}

Reading interpolated(const Reading& from, const Reading& to, double share) {
  const auto between = [&](double a, double b) { return a + share * (b - a); };
  return {between(from.t, to.t),   between(from.x, to.x),   between(from.y, to.y),
          between(from.Fx, to.Fx), between(from.Fy, to.Fy), {}};
}

}  // namespace plumbline::diagnose
