#include "diagnose/report/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnose/rig/regime.hpp"
#include "support/page/chart.hpp"

namespace plumbline::diagnose {
namespace {

using Kind = page::Layer::Kind;

std::string panel_id(const char* what, std::size_t run, const Channel& channel) {
  return fmt::format("{}-{}-{}", what, run + 1, channel.label());
}

/// One channel of a trace over the command.
std::vector<page::ChartPoint> curve(const Trace& trace, const Channel& channel, const Command& command) {
  std::vector<page::ChartPoint> points;
  for (Eigen::Index i = 0; i < trace.rows(); ++i)
    points.push_back({command.along[static_cast<std::size_t>(i)], trace(i, channel.column)});
  return points;
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
  chart.across = regime_strips(regimes(run, explained.nominal.runs[series.run]));
  chart.along = {{-2 * sigma, 2 * sigma, "noise"}};
  chart.signed_log = true;
  chart.y_range = page::ChartPoint{-most, most};
  return chart;
}

}  // namespace

std::vector<PageChart> curve_charts(const Explained& explained) {
  std::vector<PageChart> charts;
  const HeldOut heldout = heldout_of(explained);
  for (const Series& series : explained.measurements.series()) {
    const Run& run = explained.experiment.runs[series.run];
    const Command command = command_of(run);
    page::Layer measured{Kind::dots, "measured", {}, series.readings.size() > 30 ? 1.6 : 2.6};
    page::Layer set_aside{Kind::rings, "heldout", {}, 2.8};
    measured.told = true;
    for (const std::size_t i : series.readings) {
      const page::ChartPoint point{command.along[i], series.channel.of(run.readings[i])};
      measured.points.push_back(point);
      if (!heldout.empty() && heldout.reading[series.run][i]) set_aside.points.push_back(point);
    }
    page::Chart chart{
        panel_id("curve", series.run, series.channel),
        series.channel.label() + " in run " + run.id,
        "Measured values as dots, the nominal model as a thin and the corrected one as a bold line.",
        command.label,
        with_unit(series.channel),
        {{Kind::line, "nominal", curve(explained.nominal.runs[series.run], series.channel, command)}}};
    if (explained.best != nullptr)
      chart.layers.push_back(
          {Kind::line, "corrected", curve(explained.corrected.runs[series.run], series.channel, command)});
    chart.layers.push_back(measured);
    chart.layers.push_back(set_aside);
    charts.push_back({run.id + ": " + series.channel.label(), page::drawn(chart),
                      series.channel.name == Channel::Name::q});
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
                      series.channel.name == Channel::Name::q});
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
