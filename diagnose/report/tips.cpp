#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnose/report/charts.hpp"
#include "support/page/chart.hpp"

namespace plumbline::diagnose {
namespace {

using Kind = page::Layer::Kind;

/// Two coordinates of a place.
struct View {
  const char* words;
  std::size_t across, up;
};
constexpr View views[] = {{"from above", 0, 1}, {"from the side", 0, 2}};

/// A tracked point in one run.
struct Track {
  std::size_t run, point;
  auto operator<=>(const Track&) const = default;
};

/// Its measured places and what a model adds to them, mm; NaN where a coordinate was not read.
struct Vectors {
  std::vector<page::ChartPoint> from;
  std::vector<std::vector<page::ChartPoint>> to;  ///< by model

  [[nodiscard]] double longest(std::size_t model) const {
    double most = 0;
    for (const page::ChartPoint& one : to[model]) most = std::fmax(most, std::hypot(one.x, one.y));
    return most;
  }
  [[nodiscard]] double extent() const {
    double low_x = INFINITY, high_x = -INFINITY, low_y = INFINITY, high_y = -INFINITY;
    for (const page::ChartPoint& one : from) {
      low_x = std::fmin(low_x, one.x), high_x = std::fmax(high_x, one.x);
      low_y = std::fmin(low_y, one.y), high_y = std::fmax(high_y, one.y);
    }
    return std::max(high_x - low_x, high_y - low_y);
  }
};

Vectors vectors(const Study& study, const Track& track, const View& view,
                const std::vector<DrawnModel>& models) {
  const Run& run = study.experiment().runs[track.run];
  const std::size_t joints = run.rest.size();
  const auto channel = [&](std::size_t axis) {
    return Channel(Channel::Name::place, 3 * track.point + axis, joints);
  };
  const Channel across = channel(view.across), up = channel(view.up);
  const double unit = shown_unit(across).per_si;
  Vectors all{{}, std::vector<std::vector<page::ChartPoint>>(models.size())};
  for (std::size_t i = 0; i < run.readings.size(); ++i) {
    const double x = across.of(run.readings[i]), y = up.of(run.readings[i]);
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    all.from.push_back({unit * x, unit * y});
    for (std::size_t m = 0; m < models.size(); ++m) {
      const Trace& trace = models[m].prediction->runs[track.run];
      const auto row = static_cast<Eigen::Index>(i);
      all.to[m].push_back({unit * (trace(row, across.column) - x), unit * (trace(row, up.column) - y)});
    }
  }
  return all;
}

/// 1, 2 or 5 times a power of ten, so that the longest vector is about a sixth of the drawing.
double enlargement(const Vectors& all) {
  constexpr double share = 0.15;
  const double wanted = share * all.extent() / all.longest(0);
  if (!std::isfinite(wanted) || wanted <= 1) return 1;
  const double decade = std::pow(10, std::floor(std::log10(wanted))), digit = wanted / decade;
  return decade * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
}

PageChart chart_of(const Study& study, const Track& track, const View& view,
                   const std::vector<DrawnModel>& models, const Vectors& all) {
  const Run& run = study.experiment().runs[track.run];
  const std::string& point = study.experiment().arm_bench.points[track.point].name;
  const double times = enlargement(all);
  constexpr const char* axes[] = {"x, mm", "y, mm", "z, mm"};
  page::Chart chart{fmt::format("tips-{}-{}-{}", track.run + 1, track.point + 1, view.up),
                    fmt::format("Residual vectors of {} in run {}, {}", point, run.id, view.words),
                    fmt::format("Lines from each measured place towards the modelled one, {:g} times as long "
                                "as they are.",
                                times),
                    axes[view.across],
                    axes[view.up],
                    {}};
  chart.equal_axes = true;
  std::vector<std::string> longest;
  for (std::size_t m = 0; m < models.size(); ++m) {
    page::Layer lines{Kind::line, models[m].ink, {}};
    for (std::size_t i = 0; i < all.from.size(); ++i) {
      const page::ChartPoint &at = all.from[i], &way = all.to[m][i];
      lines.points.push_back(at);
      lines.points.push_back({at.x + times * way.x, at.y + times * way.y});
      lines.points.push_back({NAN, NAN});
    }
    chart.layers.push_back(std::move(lines));
    longest.push_back(fmt::format("{} model {:.3g} mm", models[m].ink, all.longest(m)));
  }
  page::Layer measured{Kind::dots, "measured", all.from, 1.8};
  measured.told = true;
  chart.layers.push_back(std::move(measured));
  return {fmt::format("{}, {} {}: from the measured place to the modelled one, drawn {:g} times as long; "
                      "longest: {}",
                      run.id, point, view.words, times, fmt::join(longest, ", ")),
          page::drawn(chart)};
}

}  // namespace

std::vector<PageChart> tip_charts(const Study& study, const std::vector<DrawnModel>& models) {
  std::vector<Track> tracks;
  for (const Series& series : study.measurements().series()) {
    const Track track{series.run, series.channel.joint / 3};
    if (series.channel.name == Channel::Name::place &&
        std::find(tracks.begin(), tracks.end(), track) == tracks.end())
      tracks.push_back(track);
  }
  std::vector<PageChart> charts;
  for (const Track& track : tracks)
    for (const View& view : views)
      if (const Vectors all = vectors(study, track, view, models); !all.from.empty())
        charts.push_back(chart_of(study, track, view, models, all));
  return charts;
}

}  // namespace plumbline::diagnose
