#include "diagnose/report/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "diagnose/rig/regime.hpp"
#include "support/page/chart.hpp"

namespace plumbline::diagnose {
namespace {

using Kind = page::Layer::Kind;
constexpr double degrees_a_radian = 57.29577951308232;

std::string panel_id(const char* what, std::size_t run, const Channel& channel) {
  return fmt::format("{}-{}-{}", what, run + 1, channel.label());
}

/// Whether lines between readings mean something: joints that are sent from pose to pose without a clock
/// pass nowhere between them.
bool is_a_path(const Study& study, std::size_t run) {
  return !study.experiment().runs[run].commands_joints() || study.measurements().has_clock(run);
}

/// Whether a channel is folded away: angles beside an end point, which are many.
bool is_beside(const Run& run, const Channel& channel) {
  return channel.name == Channel::Name::q && !run.commands_joints();
}

/// In degrees and millimetres.
Command in_shown_unit(Command command) {
  for (const auto& [si, shown, factor] :
       {std::tuple(", rad", ", deg", degrees_a_radian), std::tuple(", m", ", mm", 1e3)}) {
    if (!command.label.ends_with(si)) continue;
    command.label.replace(command.label.size() - std::string(si).size(), std::string::npos, shown);
    for (double& value : command.along) value *= factor;
    break;
  }
  return command;
}

/// Abscissae of a channel: its joint's command, where joints are commanded, else the command of the run.
Command command_for(const Run& run, const Channel& channel) {
  const bool of_joint = channel.kind().index == ChannelKind::Index::joint || run.rest.size() == 1;
  if (!run.commands_joints() || !of_joint) return in_shown_unit(command_of(run));
  Command command{{}, "command", 0};
  const std::size_t joint = run.rest.size() == 1 ? 0 : channel.joint;
  for (const Reading& reading : run.readings) command.along.push_back(reading.rest[joint]);
  if (run.rest.size() > 1) command.label += fmt::format(" of joint {}", joint + 1);
  command.label += fmt::format(", {}", unit(run.end().joint));
  return in_shown_unit(command);
}

page::Layer modelled(const DrawnModel& model, const Series& series, const Command& command, bool path) {
  const Trace& trace = model.prediction->runs[series.run];
  const double unit = shown_unit(series.channel).per_si;
  page::Layer layer{path ? Kind::line : Kind::rings, model.ink, {}, 2.4};
  for (Eigen::Index i = 0; i < trace.rows(); ++i)
    layer.points.push_back(
        {command.along[static_cast<std::size_t>(i)], unit * trace(i, series.channel.column)});
  return layer;
}

page::Strip strip_of(Regime regime, double from, double to) {
  switch (regime) {
    case Regime::near_critical:
      return {from, to, "near", "near"};
    case Regime::post_critical:
      return {from, to, "post", "post"};
    case Regime::unloading:
      return {from, to, "back", "unloading"};
    case Regime::loading:
      return {from, to, "pre", "loading"};
    case Regime::pre_critical:
      break;
  }
  return {from, to, "pre", "pre"};
}

std::vector<page::Strip> regime_strips(const std::vector<Regime>& regime) {
  std::vector<page::Strip> strips;
  for (std::size_t i = 0; i < regime.size(); ++i) {
    const auto here = static_cast<double>(i);
    if (i == 0 || regime[i] != regime[i - 1]) strips.push_back(strip_of(regime[i], here - 0.5, here + 0.5));
    strips.back().to = here + 0.5;
  }
  return strips;
}

/// Residuals of all charts share one scale, so that they can be compared.
double largest(const VectorXd& values) {
  return std::max(4.0, values.cwiseAbs().maxCoeff());
}

page::Chart residual_chart(const Explained& explained, std::size_t place, double most) {
  const Series& series = explained.series(place);
  const Run& run = explained.experiment.runs[series.run];
  const double sigma = explained.diagnosis.noise.of(series.channel).scale;
  page::Layer before{Kind::rings, "nominal", {}, 1.7}, after{Kind::dots, "corrected", {}, 2};
  before.told = after.told = true;
  for (std::size_t i = 0; i < series.readings.size(); ++i) {
    const auto reading = static_cast<double>(series.readings[i]);
    const auto value = static_cast<Eigen::Index>(series.first + i);
    before.points.push_back({reading, explained.before(value)});
    after.points.push_back({reading, explained.after(value)});
  }
  page::Chart chart{
      panel_id("residual", series.run, series.channel),
      "Residual of " + series.channel.label() + " in run " + run.id,
      "Measured minus model in declared standard deviations, reading by reading, of the nominal and of the "
      "corrected model; the regimes of the load path are shaded.",
      "reading",
      "residual of " + series.channel.label() + ", σ",
      {before}};
  if (explained.best != nullptr) chart.layers.push_back(after);
  if (!explained.experiment.visits_poses())
    chart.across = regime_strips(regimes(run, explained.nominal.runs[series.run]));
  chart.along = {{-2 * sigma, 2 * sigma, "noise"}};
  chart.signed_log = true;
  chart.y_range = page::ChartPoint{-most, most};
  return chart;
}

}  // namespace

ShownUnit shown_unit(const Channel& channel) {
  if (channel.unit() == "rad") return {degrees_a_radian, "deg"};
  if (channel.unit() == "m") return {1e3, "mm"};
  return {1, std::string(channel.unit())};
}

std::vector<PageChart> curve_charts(const Study& study, const std::vector<DrawnModel>& models,
                                    const HeldOut& heldout) {
  std::vector<PageChart> charts;
  for (const Series& series : study.measurements().series()) {
    const Run& run = study.experiment().runs[series.run];
    const bool path = is_a_path(study, series.run);
    if (!path && series.channel.name == Channel::Name::place) continue;  // of these are the residual vectors
    const Command command = command_for(run, series.channel);
    const ShownUnit unit = shown_unit(series.channel);
    page::Layer measured{Kind::dots, "measured", {}, series.readings.size() > 30 ? 1.6 : 2.6};
    page::Layer set_aside{Kind::rings, "heldout", {}, 2.8};
    measured.told = true;
    for (const std::size_t i : series.readings) {
      const page::ChartPoint point{command.along[i], unit.per_si * series.channel.of(run.readings[i])};
      measured.points.push_back(point);
      if (!heldout.empty() && heldout.reading[series.run][i]) set_aside.points.push_back(point);
    }
    page::Chart chart{
        panel_id("curve", series.run, series.channel),
        series.channel.label() + " in run " + run.id,
        path ? "Measured values as dots, the nominal model as a thin and the corrected one as a bold line."
             : "Measured values as dots, what the models say there as rings.",
        command.label,
        series.channel.label() + ", " + unit.name,
        {}};
    for (const DrawnModel& model : models) chart.layers.push_back(modelled(model, series, command, path));
    chart.layers.push_back(measured);
    chart.layers.push_back(set_aside);
    charts.push_back(
        {run.id + ": " + series.channel.label(), page::drawn(chart), is_beside(run, series.channel)});
  }
  return charts;
}

std::vector<PageChart> residual_charts(const Explained& explained) {
  const double most = std::max(largest(explained.before), largest(explained.after));
  std::vector<PageChart> charts;
  for (std::size_t s = 0; s < explained.measurements.series().size(); ++s) {
    const Series& series = explained.series(s);
    charts.push_back({explained.experiment.runs[series.run].id + ": " + series.channel.label(),
                      page::drawn(residual_chart(explained, s, most)),
                      is_beside(explained.experiment.runs[series.run], series.channel)});
  }
  return charts;
}

PageChart missing_chart(const Missing& missing) {
  page::Layer up{Kind::dots, "corrected", {}, 2}, down{Kind::rings, "nominal", {}, 2.2};
  for (const MissingPoint& point : missing.points)
    (point.falling ? down : up).points.push_back({point.at, point.value});
  const page::Chart chart{"missing",
                          "Unexplained " + missing.what + " over " + missing.against,
                          "Residual of the nominal model at each reading; dots where " + missing.against +
                              " rises, rings where it falls.",
                          missing.against + ", " + missing.against_unit,
                          missing.what + ", " + missing.unit,
                          {up, down},
                          {},
                          {},
                          {},
                          false,
                          false,
                          page::ChartPoint{0, 0}};
  return {"Unexplained " + missing.what + " over " + missing.against, page::drawn(chart)};
}

}  // namespace plumbline::diagnose
