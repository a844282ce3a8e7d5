#include "diagnose/noise/outliers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "diagnose/bench/median.hpp"
#include "diagnose/noise/residual_differences.hpp"

namespace plumbline::diagnose {
namespace {

/// Median of the values around place i of a series: of nine, or of five where the series is short.
double local_median(const Series& series, const std::vector<double>& residual, std::size_t i) {
  const std::size_t count = series.readings.size();
  const std::size_t width = count >= 18 ? 9 : std::min<std::size_t>(5, count), half = width / 2;
  const std::size_t from = std::min(i >= half ? i - half : 0, count - width);
  const auto begin = residual.begin() + static_cast<std::ptrdiff_t>(series.first + from);
  return median(std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(width)));
}

/// How many neighbours that are off to the same side are no chance: three, and more where so many of all
/// readings are far out that some three of them stand together.
std::size_t no_chance(double far_out, double readings) {
  constexpr double level = 1e-3;
  const double share = far_out / readings / 2;  // to one side
  std::size_t neighbours = 3;
  while (2 * readings * std::pow(share, static_cast<double>(neighbours)) > level) ++neighbours;
  return neighbours;
}

/// Takes back the marks of so many neighbours or more that are off to the same side: that is something that
/// lasts (a snap that comes too late, say).
void keep_what_lasts(const Series& series, const std::vector<double>& off, std::size_t lasting,
                     std::vector<bool>& marked) {
  const std::size_t end = series.first + series.readings.size();
  for (std::size_t i = series.first; i < end;) {
    std::size_t next = i + 1;
    while (next < end && marked[i] && marked[next] && (off[next] > 0) == (off[i] > 0)) ++next;
    if (marked[i] && next - i >= lasting)
      std::fill(marked.begin() + static_cast<std::ptrdiff_t>(i),
                marked.begin() + static_cast<std::ptrdiff_t>(next), false);
    i = next;
  }
}

/// Takes back the marks of what leads from the reading before to the one after: the turn of a curve is off
/// the median too.
void keep_what_leads_on(const Series& series, const std::vector<double>& residual, double tolerance,
                        std::vector<bool>& marked) {
  const std::size_t end = series.first + series.readings.size();
  for (std::size_t i = series.first + 1; i + 1 < end;) {
    std::size_t next = i;
    while (next < end && marked[next]) ++next;
    if (next > i && next < end && !marked[i - 1]) {
      const auto [low, high] = std::minmax(residual[i - 1], residual[next]);
      for (std::size_t k = i; k < next; ++k)
        if (residual[k] > low - tolerance && residual[k] < high + tolerance) marked[k] = false;
    }
    i = next + 1;
  }
}

/// Marks what stands off the local median by more than `limit` standard deviations of its channel, unless so
/// many neighbours do.
std::vector<bool> marks(const Measurements& measurements, const std::vector<double>& residual,
                        const std::array<double, channel_names>& scale, double limit, std::size_t lasting) {
  std::vector<bool> marked(residual.size(), false);
  std::vector<double> off(residual.size(), 0.0);
  for (const Series& series : measurements.series()) {
    const double tolerance = limit * scale[static_cast<std::size_t>(series.channel.name)];
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      off[series.first + i] = residual[series.first + i] - local_median(series, residual, i);
      marked[series.first + i] = series.readings.size() >= 5 && std::abs(off[series.first + i]) > tolerance;
    }
    keep_what_lasts(series, off, lasting, marked);
    keep_what_leads_on(series, residual, tolerance, marked);
  }
  return marked;
}

/// Differences of a channel and of the other one of its sensor.
std::vector<double> with_kin(const Measurements& measurements, const std::vector<double>& residual,
                             Channel::Name name) {
  std::vector<double> all;
  for (const Channel::Name other : all_names) {
    if (Channel{other, 0}.sensor() != Channel{name, 0}.sensor()) continue;
    const std::vector<double> steps = differences(series_named(measurements, other), residual, 1);
    all.insert(all.end(), steps.begin(), steps.end());
  }
  return all;
}

/// Standard deviations by channel, as far as differences of neighbours show them.
std::array<double, channel_names> rough_scales(const Measurements& measurements,
                                               const std::vector<double>& residual) {
  constexpr double least = 2.0 / 3.0;  // of the declared sigma
  constexpr std::size_t few = 30;      // a step and an outlier are then less than a sixth of them
  std::array<double, channel_names> scale{};
  for (const Channel::Name name : all_names) {
    std::vector<double> steps = differences(series_named(measurements, name), residual, 1);
    if (steps.size() < few) steps = with_kin(measurements, residual, name);
    // An outlier spoils two differences: one in twelve readings would carry Huber's variance away.
    const double found = steps.empty() ? 0 : median_deviation(steps) / std::numbers::sqrt2;
    scale[static_cast<std::size_t>(name)] = std::max({found, least, rounding(measurements, name)});
  }
  return scale;
}

std::vector<double> smoothed_over(const Measurements& measurements, const std::vector<double>& residual,
                                  const std::vector<bool>& marked) {
  std::vector<double> clean = residual;
  for (const Series& series : measurements.series()) {
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      if (marked[series.first + i]) clean[series.first + i] = local_median(series, residual, i);
  }
  return clean;
}

}  // namespace

std::vector<bool> outliers(const Measurements& measurements, const std::vector<double>& residual) {
  constexpr double limit = 5;  // one false mark in a million readings of normal noise
  constexpr double heavy_limit = 3, heavy_share = 0.015, heavy_count = 3;
  const auto readings = static_cast<double>(residual.size());
  const std::vector<bool> marked =
      marks(measurements, residual, rough_scales(measurements, residual), limit, no_chance(0, readings));
  const auto count = static_cast<double>(std::count(marked.begin(), marked.end(), true));
  if (count < heavy_count || count <= heavy_share * readings) return marked;
  // So many far out have more between them and the rest.
  const std::vector<double> clean = smoothed_over(measurements, residual, marked);
  return marks(measurements, residual, rough_scales(measurements, clean), heavy_limit,
               no_chance(count, readings));
}

std::vector<double> without_outliers(const Measurements& measurements, const std::vector<double>& residual) {
  return smoothed_over(measurements, residual, outliers(measurements, residual));
}

}  // namespace plumbline::diagnose
