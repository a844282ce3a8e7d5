#include "diagnose/inference/noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {
namespace {

/// Variance by Huber's proposal 2: squares are cut at (2.5 s)^2 and the mean is corrected for the cut. Nearly
/// as efficient as the plain variance, and a few percent of outliers move it by a few percent; but 16 % carry
/// it away, 0.97756 / 2.5^2.
double robust_variance(const std::vector<double>& differences) {
  constexpr double cut = 2.5;
  constexpr double mean_of_cut_square = 0.97756;  // E min(z^2, 2.5^2) for a standard normal z
  double variance = std::pow(median_deviation(differences), 2);
  for (int round = 0; round < 20; ++round) {
    const double limit = cut * cut * variance;
    double sum = 0;
    for (const double d : differences) sum += std::min(d * d, limit);
    const double next = sum / static_cast<double>(differences.size()) / mean_of_cut_square;
    if (std::abs(next - variance) <= 1e-6 * variance) return next;
    variance = next;
  }
  return variance;
}

using Name = Channel::Name;

constexpr std::array<Name, channel_names> all_names{Name::x, Name::y, Name::Fx, Name::Fy, Name::q};

/// Differences of values `lag` apart, of all series of one name.
std::vector<double> differences(const Measurements& measurements, const std::vector<double>& residual,
                                Name name, std::size_t lag) {
  std::vector<double> result;
  for (const Series& series : measurements.series()) {
    if (series.channel.name != name) continue;
    for (std::size_t i = lag; i < series.readings.size(); ++i)
      result.push_back(residual[series.first + i] - residual[series.first + i - lag]);
  }
  return result;
}

/// Differences of neighbouring differences.
std::vector<double> second_differences(const Measurements& measurements, const std::vector<double>& residual,
                                       Name name) {
  std::vector<double> result;
  for (const Series& series : measurements.series()) {
    if (series.channel.name != name) continue;
    for (std::size_t i = series.first + 2; i < series.first + series.readings.size(); ++i)
      result.push_back(residual[i - 2] - 2 * residual[i - 1] + residual[i]);
  }
  return result;
}

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

/// Combines a measured scale with its prior: log-normal about one, as wide as is believed, or as the readings
/// themselves ask for, where there are enough of them: the differences of a few are steps of a gap as well.
double with_prior(double scale, double values) {
  constexpr double few = 6;  // from a dozen differences
  const double asked = values < few ? 0 : std::abs(std::log(scale));
  const double spread = std::max(beliefs::scale_spread, asked);
  const double information = values;  // the variance of ln s from m differences is about 1/m
  return std::exp(std::log(scale) * information / (information + 1 / (spread * spread)));
}

}  // namespace

namespace {

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
                             Name name) {
  std::vector<double> all;
  for (const Name other : all_names) {
    if (Channel{other, 0}.sensor() != Channel{name, 0}.sensor()) continue;
    const std::vector<double> steps = differences(measurements, residual, other, 1);
    all.insert(all.end(), steps.begin(), steps.end());
  }
  return all;
}

/// Standard deviation of what rounding to a coarse scale does, the largest of a channel's series.
double rounding(const Measurements& measurements, Name name) {
  double step = 0;
  for (const Series& series : measurements.series())
    if (series.channel.name == name) step = std::max(step, series.step);
  return step / std::sqrt(12.0);
}

/// Standard deviation of what values are off those that were read at the same place, with room for what it
/// varies by and for chance. Infinite where there are few.
double largest_of(const std::vector<double>& off) {
  constexpr std::size_t few = 8;
  if (off.size() < few) return std::numeric_limits<double>::infinity();
  // Every second of such differences is new: two deviations of their root mean square.
  const double room = 1.5 + 2 / std::sqrt(static_cast<double>(off.size()));
  return room * std::sqrt(robust_variance(off));
}

/// Standard deviation of a channel as values show it that were read close to each other on the path, at other
/// times of a run or in another run: neither what changes along the path nor what is slow is in it.
double largest_in_place(const Measurements& measurements, const std::vector<double>& residual, Name name) {
  std::vector<double> within, across;
  for (const Series& series : measurements.series()) {
    if (series.channel.name != name) continue;
    for (const Between& one : series.between) within.push_back(one.off(residual.data() + series.first));
  }
  for (const Repeats& repeats : measurements.repeats()) {
    if (repeats.channel.name != name) continue;
    std::vector<double> values;
    for (const std::size_t value : repeats.values) values.push_back(residual[value]);
    for (const Between& one : repeats.between) across.push_back(one.off(values.data()));
  }
  return std::min(largest_of(within), largest_of(across));
}

/// What no scale of a channel's noise exceeds: readings that go smoothly have no more noise than they are
/// rough, whatever a model leaves of them. Noise that most of a run has less of, in proportion to small
/// readings, say, or that changes slowly, shows a part of itself alone in the middle of third differences.
double scale_bound(const Measurements& measurements, double in_place, Name name) {
  constexpr double hidden = 3;
  double rough = 0;
  for (const Series& series : measurements.series())
    if (series.channel.name == name) rough = std::max(rough, series.roughness);
  // What rounds a value alike whenever it comes by shows neither in place nor where readings stand still.
  const double rounded = rounding(measurements, name);
  return std::max(std::hypot(1.0, rounded), std::hypot(std::min(hidden * rough, in_place), rounded));
}

/// Standard deviations by channel, as far as differences of neighbours show them.
std::array<double, channel_names> rough_scales(const Measurements& measurements,
                                               const std::vector<double>& residual) {
  constexpr double least = 2.0 / 3.0;  // of the declared sigma
  constexpr std::size_t few = 30;      // a step and an outlier are then less than a sixth of them
  std::array<double, channel_names> scale{};
  for (const Name name : all_names) {
    std::vector<double> steps = differences(measurements, residual, name, 1);
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

namespace {

/// Variance of one channel's noise times 1 - phi, as first differences show it, and how much larger
/// differences over two readings are; without the variance that rounding adds, which does not correlate.
struct Steps {
  double near = 0, ratio = 1, curved = 0, values = 0, rounded = 0;
};

Steps steps_of(const Measurements& measurements, const std::vector<double>& residual, Name name) {
  const std::vector<double> near = differences(measurements, residual, name, 1);
  const std::vector<double> far = differences(measurements, residual, name, 2);
  Steps steps;
  steps.values = static_cast<double>(near.size());
  if (near.empty() || far.empty()) return steps;
  const double plain = robust_variance(near) / 2;
  if (!(plain > 0)) return steps;
  // Of coarser readings, which repeat, the rest is no noise.
  if (const double variance = std::pow(rounding(measurements, name), 2); variance <= plain / 2)
    steps.rounded = variance;
  steps.near = plain - steps.rounded;
  steps.ratio = (robust_variance(far) / 2 - steps.rounded) / steps.near;
  steps.curved = robust_variance(second_differences(measurements, residual, name)) / 2 - 3 * steps.rounded;
  return steps;
}

std::array<Steps, channel_names> steps_by_channel(const Measurements& measurements,
                                                  const std::vector<double>& residual) {
  std::array<Steps, channel_names> steps;
  for (const Name name : all_names)
    steps[static_cast<std::size_t>(name)] = steps_of(measurements, residual, name);
  return steps;
}

/// Noise of the declared scale whose first differences are no larger than these correlates by 1 - near.
double largest_correlation(const Measurements& measurements, const std::array<Steps, channel_names>& steps,
                           Sensor sensor) {
  std::vector<double> lengths;
  double rough = 0;
  for (const Series& series : measurements.series()) {
    if (series.channel.sensor() != sensor) continue;
    lengths.push_back(static_cast<double>(series.readings.size()));
    rough = std::max(rough, steps[static_cast<std::size_t>(series.channel.name)].near);
  }
  return lengths.empty() ? 0 : std::min(0.9, std::max(std::exp(-10 / median(lengths)), 1 - rough));
}

std::size_t sensor_of(std::size_t name) {
  return static_cast<std::size_t>(Channel{all_names[name]}.sensor());
}

/// What noise that seems to correlate so much really may, for it would scatter more in place than it does.
BySensor correlation_in_place(const std::array<double, channel_names>& in_place,
                              const std::array<Steps, channel_names>& steps, const BySensor& seeming) {
  BySensor largest = seeming;
  for (std::size_t c = 0; c < steps.size(); ++c) {
    const std::size_t k = sensor_of(c);
    const double most = in_place[c] * in_place[c];
    if (steps[c].near > (1 - seeming[k]) * most)
      largest[k] = std::clamp(1 - steps[c].near / most, 0.0, largest[k]);
  }
  return largest;
}

/// What the ratios of differences say of each sensor's correlation.
BySensor raw_correlation(const std::array<Steps, channel_names>& steps) {
  BySensor ratio{}, weight{}, correlation{};
  for (std::size_t c = 0; c < steps.size(); ++c) {
    // Differences over two readings that exceed twice those over one by more than chance, one in twenty, are
    // of a slope, not of noise.
    const double by_chance = 1.64 * correlation_deviation(1, steps[c].values);
    if (!(steps[c].near > 0) || steps[c].ratio > 2 + by_chance) continue;
    ratio[sensor_of(c)] += steps[c].values * std::min(2.0, steps[c].ratio);
    weight[sensor_of(c)] += steps[c].values;
  }
  // (1 - phi^2) / (1 - phi) = 1 + phi
  for (std::size_t k = 0; k < sensors; ++k)
    if (weight[k] > 0) correlation[k] = ratio[k] / weight[k] - 1;
  return correlation;
}

}  // namespace

double correlation_deviation(double correlation, double values) {
  return (1.4 + 0.8 * correlation) / std::sqrt(values);
}

RawNoise raw_noise(const Measurements& measurements, const std::vector<double>& residual) {
  RawNoise noise;
  const std::array<Steps, channel_names> steps = steps_by_channel(measurements, residual);
  for (std::size_t c = 0; c < steps.size(); ++c) {
    noise.values[c] = steps[c].values;
    noise.largest_in_place[c] = largest_in_place(measurements, residual, all_names[c]);
  }
  noise.correlation = raw_correlation(steps);
  BySensor seeming{};
  for (std::size_t k = 0; k < sensors; ++k) {
    noise.largest_correlation[k] = largest_correlation(measurements, steps, static_cast<Sensor>(k));
    seeming[k] = std::clamp(noise.correlation[k], 0.0, noise.largest_correlation[k]);
  }
  const BySensor taken = correlation_in_place(noise.largest_in_place, steps, seeming);
  for (std::size_t k = 0; k < sensors; ++k)
    if (taken[k] < seeming[k]) noise.largest_correlation[k] = taken[k];
  for (std::size_t c = 0; c < steps.size(); ++c) {
    if (!(steps[c].near > 0)) continue;
    const double phi = taken[sensor_of(c)];
    const double straight = steps[c].near / (1 - phi), curved = steps[c].curved / ((1 - phi) * (3 - phi));
    const double fine = steps[c].ratio > 2 && curved > 0 ? std::min(straight, curved) : straight;
    noise.scale[c] = std::sqrt(fine + steps[c].rounded);
  }
  return noise;
}

NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual) {
  const RawNoise raw = raw_noise(measurements, residual);
  BySensor values{}, taken{};
  for (std::size_t c = 0; c < raw.values.size(); ++c) values[sensor_of(c)] += raw.values[c];
  NoiseModel noise;
  // The estimate's variance is about 1/values.
  constexpr double prior = 1 / (beliefs::correlation_spread * beliefs::correlation_spread);
  for (std::size_t k = 0; k < sensors; ++k) {
    const double weight = values[k] / (values[k] + prior);
    noise.correlation[k] = std::clamp(weight * raw.correlation[k], 0.0, raw.largest_correlation[k]);
    taken[k] = std::clamp(raw.correlation[k], 0.0, raw.largest_correlation[k]);
  }
  for (std::size_t c = 0; c < noise.scale.size(); ++c) {
    const std::size_t k = sensor_of(c);
    const double scale = raw.scale[c] * std::sqrt((1 - taken[k]) / (1 - noise.correlation[k]));
    // What is declared is of the sensor, before its readings are rounded.
    const double declared = std::hypot(1.0, rounding(measurements, all_names[c]));
    noise.scale[c] = declared;
    if (raw.values[c] > 0 && scale > 0) noise.scale[c] *= with_prior(scale / declared, raw.values[c] / 2);
    // Large and slow at once is a gap, not noise; in runs too short for noise so slow, what has a slope.
    if (noise.correlation[k] > 0.5 || raw.correlation[k] > 0.9)
      noise.scale[c] = std::min(noise.scale[c], std::max(1.5, declared));
    noise.scale[c] =
        std::min(noise.scale[c], scale_bound(measurements, raw.largest_in_place[c], all_names[c]));
  }
  return noise;
}

std::array<PossibleCorrelation, 2> larger_correlations(const Measurements& measurements,
                                                       const std::vector<double>& residual,
                                                       const BySensor& estimated) {
  BySensor values{};
  for (const Series& series : measurements.series())
    values[static_cast<std::size_t>(series.channel.sensor())] += static_cast<double>(series.readings.size());
  const BySensor largest = raw_noise(measurements, residual).largest_correlation;
  std::array<PossibleCorrelation, 2> all{{{{}, 0.2220759}, {{}, 0.0112574}}};
  constexpr std::array<double, 2> deviations{1.3556262, 2.8569700};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < sensors; ++k)
      if (values[k] > 0)
        all[i].value[k] = std::clamp(
            estimated[k] + deviations[i] * correlation_deviation(estimated[k], values[k]), 0.0, largest[k]);
  return all;
}

Eigen::VectorXd whitened(const Eigen::Ref<const Eigen::VectorXd>& values, double scale, double correlation) {
  Eigen::VectorXd white = values / scale;
  const Eigen::Index later = values.size() - 1;
  const double innovation = std::sqrt(1 - correlation * correlation);
  white.tail(later) = (values.tail(later) - correlation * values.head(later)) / (scale * innovation);
  return white;
}

std::vector<double> whiten(const Measurements& measurements, const std::vector<double>& residual,
                           const NoiseModel& noise) {
  std::vector<double> white(residual.size());
  for (const Series& series : measurements.series()) {
    const auto count = static_cast<Eigen::Index>(series.readings.size());
    Eigen::Map<Eigen::VectorXd>(white.data() + series.first, count) =
        whitened(Eigen::Map<const Eigen::VectorXd>(residual.data() + series.first, count),
                 noise.of(series.channel), noise.correlation_of(series.channel));
  }
  return white;
}

}  // namespace plumbline::diagnose
