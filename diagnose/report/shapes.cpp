#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/chain/kinematics.hpp>
#include <set>

#include "diagnose/report/charts.hpp"
#include "diagnose/rig/effects/rows.hpp"
#include "support/page/chart.hpp"

namespace plumbline::diagnose {
namespace {

using Kind = page::Layer::Kind;

/// Joint positions and the end point.
std::vector<page::ChartPoint> shape(const Chain<double>& chain, const std::vector<double>& q) {
  std::vector<page::ChartPoint> points;
  for (const Point<double>& place : joint_places(chain, q)) points.push_back({place.x, place.y});
  return points;
}

/// The joint angles of a reading, measured or modelled.
std::vector<double> angles(const Explained& explained, std::size_t run, std::size_t reading, bool measured) {
  const std::size_t joints = explained.experiment.link_length.size();
  if (measured) return explained.experiment.runs[run].readings[reading].angles(joints);
  std::vector<double> q;
  const Trace& trace = explained.corrected.runs[run];
  for (std::size_t j = 0; j < joints; ++j)
    q.push_back(trace(static_cast<Eigen::Index>(reading), column_q + static_cast<Eigen::Index>(j)));
  return q;
}

/// Two readings on the path and the farthest; only the last must exist.
std::vector<std::size_t> stations(std::size_t farthest) {
  const std::set<std::size_t> chosen{farthest / 3, 2 * farthest / 3, farthest};
  return {chosen.begin(), chosen.end()};
}

/// The direction away from the links that meet at a joint.
page::ChartPoint beside(const std::vector<page::ChartPoint>& points, std::size_t joint) {
  const page::ChartPoint &at = points[joint], &last = points[joint > 0 ? joint - 1 : 0],
                         &next = points[joint + 1];
  const double along_x = next.x - last.x, along_y = next.y - last.y, length = std::hypot(along_x, along_y);
  if (!(length > 0)) return {0, 1};
  const page::ChartPoint left{-along_y / length, along_x / length};
  const double off = (at.x - last.x) * left.x + (at.y - last.y) * left.y;
  return off < 0 ? page::ChartPoint{-left.x, -left.y} : left;
}

/// The joints of one shape: small rings, and rings whose area is the joint's share.
void add_joints(page::Chart& chart, const std::vector<page::ChartPoint>& points,
                const std::vector<JointShare>& shares) {
  page::Layer joints{Kind::rings, "joint", points, 2.6};
  for (const JointShare& one : shares) {
    if (one.share < 0.01) continue;
    const page::ChartPoint& at = points[one.joint - 1];
    const double radius = 16 * std::sqrt(one.share);
    chart.layers.push_back({Kind::rings, "share", {at}, radius});
    if (one.share >= 0.05)
      chart.labels.push_back({at, fmt::format("{}: {:.0f} %", one.joint, 100 * one.share), radius + 4,
                              beside(points, one.joint - 1)});
  }
  chart.layers.push_back(joints);
}

PageChart shape_chart(const Explained& explained, std::size_t r) {
  const Experiment& experiment = explained.experiment;
  const Run& run = experiment.runs[r];
  const Chain<double> chain(experiment.link_length, experiment.joint_stiffness);
  const bool measured = run.reads_angles();
  const std::string whose =
      measured ? "measured shapes" : "shapes of the " + explained.model + ", no angles measured";
  page::Chart chart{
      fmt::format("shape-{}", r + 1),
      "The chain in run " + run.id,
      "The unloaded chain dashed, two shapes on the way in grey and the farthest in black, from joint 1 at "
      "the origin; the area of a ring is the joint's share of the gap.",
      "x, m",
      "y, m",
      {{Kind::line, "shape-0", shape(chain, run.rest)}}};
  chart.equal_axes = true;
  std::vector<page::ChartPoint> last = chart.layers.front().points;
  const std::vector<std::size_t> readings = stations(command_of(run).farthest);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const std::vector<double> q = angles(explained, r, readings[i], measured);
    if (!std::all_of(q.begin(), q.end(), [](double angle) { return std::isfinite(angle); })) continue;
    last = shape(chain, q);
    chart.layers.push_back({Kind::line, fmt::format("shape-{}", i + 1 + 3 - readings.size()), last});
  }
  add_joints(chart, last,
             at_joints(explained) ? explained.diagnosis.where.joints : std::vector<JointShare>{});
  return {run.id + ": " + whose, page::drawn(chart)};
}

}  // namespace

bool at_joints(const Explained& explained) {
  if (!explained.diagnosis.gap.present) return false;
  if (explained.best == nullptr || explained.diagnosis.cause.verdict == CauseVerdict::unknown) return true;
  const std::vector<EffectAt>& effects = explained.best->cause.effects;
  return std::any_of(effects.begin(), effects.end(), [](const EffectAt& at) {
    if (at.effect->at_joint) return true;
    for (const auto& rows : {joint_effects(), common_effects(), joint_law_effects(), friction_effects()})
      for (const Effect& row : rows)
        if (row.id == at.effect->id) return true;
    return false;
  });
}

std::vector<PageChart> shape_charts(const Explained& explained) {
  std::vector<PageChart> charts;
  if (!explained.experiment.is_planar()) return charts;
  for (std::size_t r = 0; r < explained.experiment.runs.size(); ++r)
    charts.push_back(shape_chart(explained, r));
  return charts;
}

}  // namespace plumbline::diagnose
