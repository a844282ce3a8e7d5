#include "diagnose/rig/substeps.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

bool slips(std::size_t sliders, const Rig& rig) {
  return sliders > 0 || std::isfinite(rig.yield) ||
         std::any_of(rig.slip.begin(), rig.slip.end(), [](double torque) { return std::isfinite(torque); });
}

/// Whether slip is followed between readings. A free torque law knows only the history at the readings, and
/// friction by the speed of the step before would oscillate.
bool slips_on_the_way(std::size_t sliders, const Rig& rig) {
  return slips(sliders, rig) && rig.laws.empty() && rig.friction_law.fall == 0;
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

/// Those in which commanded links turn no farther than an angle.
std::vector<std::size_t> by_turns(const Run& run, const Reading& first) {
  constexpr double turn = 0.25;  // rad: so that it is not a snap
  std::vector<std::size_t> all;
  const Reading* last = &first;
  for (const Reading& here : run.readings) {
    all.push_back(static_cast<std::size_t>(std::ceil(std::max(1.0, most_turned(*last, here) / turn))));
    last = &here;
  }
  return all;
}

/// Those in proportion to the way of what leads or loads the end.
std::vector<std::size_t> by_way(const Run& run, const Reading& first) {
  constexpr double least = 48;  // to the farthest command
  const Eigen::Vector2d start = run.command(first);
  double farthest = 0;
  for (const Reading& one : run.readings)
    if (const double way = (run.command(one) - start).norm(); std::isfinite(way))
      farthest = std::max(farthest, way);
  std::vector<std::size_t> all(run.readings.size(), 1);
  const Reading* last = &first;
  for (std::size_t r = 0; r < all.size(); ++r) {
    const double way = (run.command(run.readings[r]) - run.command(*last)).norm();
    if (!std::isfinite(way)) continue;
    if (farthest > 0) all[r] = static_cast<std::size_t>(std::ceil(std::max(1.0, least * way / farthest)));
    last = &run.readings[r];
  }
  return all;
}

}  // namespace

std::vector<std::size_t> substeps(const Run& run, std::size_t sliders, const Rig& rig) {
  if (run.readings.empty()) return {};
  const Reading first = run.before_first().value_or(run.readings.front());
  std::vector<std::size_t> all(run.readings.size(), 1);
  if (run.commands_joints()) all = by_turns(run, first);
  if (!slips_on_the_way(sliders, rig) || (run.commands_joints() && run.loads.empty())) return all;
  const std::vector<std::size_t> along = by_way(run, first);
  for (std::size_t r = 0; r < all.size(); ++r) all[r] = std::max(all[r], along[r]);
  return all;
}

bool remembers(const Rig& rig, std::size_t sliders) {
  const bool yields = std::any_of(rig.stiffness.begin(), rig.stiffness.end(), [](double k) { return k > 0; });
  return yields && (slips(sliders, rig) || !arm_times(rig).empty());
}

}  // namespace plumbline::diagnose
