#include "diagnose/rig/substeps.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// Whether slip is followed between readings. A free torque law knows only the history at the readings, and
/// friction by the speed of the step before would oscillate.
bool slips_on_the_way(const Layout& layout, const Rig& rig) {
  const bool slips =
      layout.sliders > 0 || std::isfinite(rig.yield) ||
      std::any_of(rig.slip.begin(), rig.slip.end(), [](double torque) { return std::isfinite(torque); });
  return slips && rig.laws.empty() && rig.friction_law.fall == 0;
}

/// The largest turn of a link in the unloaded shape between two readings.
double most_turned(const Reading& from, const Reading& to) {
  double theta = 0, most = 0;
  for (std::size_t i = 0; i < from.rest.size(); ++i) {
    theta += to.rest[i] - from.rest[i];
    most = std::max(most, std::abs(theta));
  }
  return most;
}

}  // namespace

std::vector<std::size_t> substeps(const Run& run, const Layout& layout, const Rig& rig) {
  constexpr double least = 48;  // substeps to the farthest command
  constexpr double turn =
      0.25;  // rad: farthest that commanded links turn in a substep, so that it is not a snap
  std::vector<std::size_t> all(run.readings.size(), 1);
  const bool slips = slips_on_the_way(layout, rig);
  if (all.empty() || !(slips || run.commands_joints())) return all;
  const Reading first = run.before_first().value_or(run.readings.front());
  const Eigen::Vector2d start = run.command(first);
  double farthest = 0;
  for (const Reading& one : run.readings)
    if (const double way = (run.command(one) - start).norm(); std::isfinite(way))
      farthest = std::max(farthest, way);
  const Reading* last = &first;
  for (std::size_t r = 0; r < all.size(); ++r) {
    const Reading& here = run.readings[r];
    const double way = (run.command(here) - run.command(*last)).norm();
    if (!std::isfinite(way)) continue;
    const double by_way = slips && farthest > 0 ? least * way / farthest : 0;
    all[r] = static_cast<std::size_t>(std::ceil(std::max({1.0, by_way, most_turned(*last, here) / turn})));
    last = &here;
  }
  return all;
}

}  // namespace plumbline::diagnose
