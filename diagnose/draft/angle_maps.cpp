#include "diagnose/draft/angle_maps.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/draft/rest_shape.hpp"

namespace plumbline::diagnose {
namespace {

/// Sum of the distances between the end points that were read and those of the joint angles, m; NaN without
/// both.
double distance(const DraftedRun& run, const NominalChain& chain) {
  const std::vector<double> xs = run.values(draft_x), ys = run.values(draft_y);
  std::vector<std::vector<double>> angles;
  for (const DraftColumn& column : run.angles) angles.push_back(run.values(column, quantity::angle));
  double sum = xs.empty() || ys.empty() || angles.empty() ? NAN : 0;
  for (std::size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) {
    std::vector<double> q;
    for (const std::vector<double>& one : angles) q.push_back(one[i]);
    const std::array<double, 2> end = end_point(chain, q);
    if (const double gap = std::hypot(xs[i] - end[0], ys[i] - end[1]); std::isfinite(gap)) sum += gap;
  }
  return sum;
}

}  // namespace

bool reads_joints_of_model(const DraftedRun& run, const DraftModel& model) {
  const auto is_same = [](const AngleMap& map) { return map.sign > 0 && std::abs(map.straight) < 1e-9; };
  if (std::all_of(model.angles.begin(), model.angles.end(), is_same)) return false;
  DraftedRun mapped = run;
  take_angle_maps(model, mapped.angles);
  const double as_read = distance(run, model.chain), as_mapped = distance(mapped, model.chain);
  return std::isnan(as_read) || as_mapped < as_read;
}

void take_angle_maps(const DraftModel& model, std::vector<DraftColumn>& angles) {
  for (std::size_t j = 0; j < angles.size(); ++j) {
    const AngleMap& map = model.angles[j];
    DraftColumn& column = angles[j];
    const double unit = column.unit.empty() ? 1 : parse_unit(column.unit, quantity::angle, "").in_si();
    // sign (reading - zero) unit = map.sign (own sign reading unit) + straight
    column.sign = map.sign < 0 ? -column.sign : column.sign;
    column.zero = -column.sign * map.straight / unit;
  }
}

}  // namespace plumbline::diagnose
