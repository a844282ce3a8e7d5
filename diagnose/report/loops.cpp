#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/discrepancy/torque_balance.hpp"
#include "diagnose/report/charts.hpp"
#include "diagnose/rig/regime.hpp"
#include "support/page/chart.hpp"

namespace plumbline::diagnose {
namespace {

using Kind = page::Layer::Kind;

bool turns_back(const Explained& explained, std::size_t run) {
  const std::vector<Regime> regime = regimes(explained.experiment.runs[run], explained.nominal.runs[run]);
  return std::find(regime.begin(), regime.end(), Regime::unloading) != regime.end();
}

/// For each run that reverses, the series with the largest dissipation in sigmas, joint angles excluded.
std::vector<std::size_t> telling_series(const Explained& explained, const Prediction& elastic) {
  const VectorXd left = explained.measurements.residual(elastic);
  std::map<std::size_t, std::pair<double, std::size_t>> most;
  for (std::size_t s = 0; s < explained.measurements.series().size(); ++s) {
    const Series& series = explained.series(s);
    if (series.channel.name == Channel::Name::q || !turns_back(explained, series.run)) continue;
    const double sum = left.segment(static_cast<Eigen::Index>(series.first),
                                    static_cast<Eigen::Index>(series.readings.size()))
                           .squaredNorm();
    auto& best = most[series.run];
    if (sum > best.first) best = {sum, s};
  }
  std::vector<std::size_t> chosen;
  for (const auto& [run, best] : most)
    if (best.first > 0) chosen.push_back(best.second);
  return chosen;
}

PageChart loop_over_command(const Explained& explained, const Series& series, const Prediction& elastic) {
  const Run& run = explained.experiment.runs[series.run];
  const Command command = command_of(run);
  const Trace &base = elastic.runs[series.run], &whole = explained.corrected.runs[series.run];
  const Eigen::Index column = series.channel.column;
  page::Layer measured{Kind::dots, "measured", {}}, modelled{Kind::line, "corrected", {}};
  modelled.directed = measured.told = true;
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    modelled.points.push_back({command.along[i], whole(row, column) - base(row, column)});
    measured.points.push_back({command.along[i], series.channel.of(run.readings[i]) - base(row, column)});
  }
  const std::string what = series.channel.label();
  const page::Chart chart{fmt::format("loop-{}", series.run + 1),
                          "Loop of " + what + " in run " + run.id,
                          "What is left of " + what +
                              " after the elastic model, measured as dots, modelled as a line: "
                              "the way out and the way back differ.",
                          command.label,
                          what + " less the elastic model, " + std::string(series.channel.unit()),
                          {modelled, measured}};
  return {run.id + ": " + what + " less the elastic part of the model", page::drawn(chart)};
}

/// Torque residual over the angle of one joint in one run; a reading without all angles interrupts the line.
std::vector<page::ChartPoint> torque_over_angle(const std::vector<MissingTorque>& torques, std::size_t run) {
  std::vector<page::ChartPoint> points;
  for (const MissingTorque& one : torques)
    if (one.run == run) points.push_back({one.angle, one.torque});
  return points;
}

PageChart loop_at_joint(const Explained& explained, std::size_t joint, std::size_t run) {
  const auto measured = missing_torques(explained.study, explained.experiment),
             modelled =
                 missing_torques(explained.study, as_measured(explained.experiment, explained.corrected));
  page::Chart chart{
      fmt::format("torque-loop-{}", run + 1),
      fmt::format("Loop of the torque at joint {} in run {}", joint, explained.experiment.runs[run].id),
      "The torque that the nominal statics miss at the joint over its angle, measured as dots, of the "
      "corrected model as a line.",
      fmt::format("q{}, rad", joint),
      fmt::format("torque missing at joint {}, N m", joint),
      {{Kind::line, "corrected", torque_over_angle(modelled[joint - 1], run)},
       {Kind::dots, "measured", torque_over_angle(measured[joint - 1], run)}}};
  chart.layers.front().directed = chart.layers.back().told = true;
  return {fmt::format("{}: torque missing at joint {}", explained.experiment.runs[run].id, joint),
          page::drawn(chart)};
}

}  // namespace

std::vector<PageChart> loop_charts(const Explained& explained) {
  if (explained.best == nullptr) return {};
  const Hypothesis& best = explained.best->hypothesis;
  const Instance elastic = part(explained.study, best.candidate, best.parameters,
                                [](const EffectAt& at) { return !at.effect->dissipates; });
  if (elastic.candidate == best.candidate) return {};
  const Prediction base = predict(explained.study, elastic.candidate, elastic.parameters);
  if (!base.reached) return {};
  std::vector<PageChart> charts;
  const bool torques = explained.diagnosis.where.joint_evidence == JointEvidence::measured;
  for (const std::size_t place : telling_series(explained, base)) {
    const Series& series = explained.series(place);
    charts.push_back(loop_over_command(explained, series, base));
    if (torques && explained.experiment.runs[series.run].reads_angles())
      charts.push_back(loop_at_joint(explained, explained.diagnosis.where.joints.front().joint, series.run));
  }
  return charts;
}

}  // namespace plumbline::diagnose
