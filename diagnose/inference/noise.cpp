#include "diagnose/inference/noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/bench/median.hpp"
#include "diagnose/inference/slow.hpp"

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

/// Series of one channel that are read at one pace.
using Alike = std::vector<const Series*>;

/// All series of one name, whatever their pace.
Alike named(const Measurements& measurements, Name name) {
  Alike all;
  for (const Series& series : measurements.series())
    if (series.channel.name == name) all.push_back(&series);
  return all;
}

/// Differences of values `lag` apart.
std::vector<double> differences(const Alike& all, const std::vector<double>& residual, std::size_t lag) {
  std::vector<double> result;
  for (const Series* one : all) {
    const Series& series = *one;
    for (std::size_t i = lag; i < series.readings.size(); ++i)
      result.push_back(residual[series.first + i] - residual[series.first + i - lag]);
  }
  return result;
}

/// Differences of neighbouring differences.
std::vector<double> second_differences(const Alike& all, const std::vector<double>& residual) {
  std::vector<double> result;
  for (const Series* one : all) {
    const Series& series = *one;
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
    const std::vector<double> steps = differences(named(measurements, other), residual, 1);
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
    std::vector<double> steps = differences(named(measurements, name), residual, 1);
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

/// Variance of the noise of a channel, read at one pace, times 1 - phi, as first differences show it, and how
/// much larger differences over two readings are; without the variance that rounding adds, which does not
/// correlate.
struct Steps {
  std::size_t name = 0;
  double pace = 1;
  double near = 0, ratio = 1, curved = 0, values = 0, rounded = 0;

  [[nodiscard]] std::size_t sensor() const {
    return static_cast<std::size_t>(Channel{all_names[name]}.sensor());
  }
  /// phi, from that where the sensor is read fastest.
  [[nodiscard]] double correlation(const BySensor& fastest) const {
    return std::pow(fastest[sensor()], pace);
  }
};

Steps steps_of(const Measurements& measurements, const std::vector<double>& residual, const Alike& all,
               double pace) {
  const Name name = all.front()->channel.name;
  const std::vector<double> near = differences(all, residual, 1), far = differences(all, residual, 2);
  Steps steps{static_cast<std::size_t>(name), pace};
  steps.values = static_cast<double>(near.size());
  if (near.empty() || far.empty()) return steps;
  const double plain = robust_variance(near) / 2;
  if (!(plain > 0)) return steps;
  // Of coarser readings, which repeat, the rest is no noise.
  if (const double variance = std::pow(rounding(measurements, name), 2); variance <= plain / 2)
    steps.rounded = variance;
  steps.near = plain - steps.rounded;
  steps.ratio = (robust_variance(far) / 2 - steps.rounded) / steps.near;
  steps.curved = robust_variance(second_differences(all, residual)) / 2 - 3 * steps.rounded;
  return steps;
}

/// Of every channel, by the paces at which it is read where these matter.
std::vector<Steps> all_steps(const Measurements& measurements, const std::vector<double>& residual,
                             const ForgetsWithTime& with_time) {
  std::map<std::pair<Name, double>, Alike> alike;
  for (const Series& series : measurements.series()) {
    const bool paced = with_time[static_cast<std::size_t>(series.channel.sensor())];
    alike[{series.channel.name, paced ? series.pace : 1}].push_back(&series);
  }
  std::vector<Steps> steps;
  for (const auto& [where, all] : alike) steps.push_back(steps_of(measurements, residual, all, where.second));
  return steps;
}

/// Noise of the declared scale whose first differences are no larger than these correlates by 1 - near.
double largest_correlation(const Measurements& measurements, const std::vector<Steps>& steps, Sensor sensor) {
  std::vector<double> lengths;
  for (const Series& series : measurements.series())
    if (series.channel.sensor() == sensor) lengths.push_back(static_cast<double>(series.readings.size()));
  double rough = 0;
  for (const Steps& one : steps)
    if (one.sensor() == static_cast<std::size_t>(sensor) && one.pace == 1) rough = std::max(rough, one.near);
  return lengths.empty() ? 0 : std::min(0.9, std::max(std::exp(-10 / median(lengths)), 1 - rough));
}

/// What noise that seems to correlate so much really may, for it would scatter more in place than it does.
BySensor correlation_in_place(const std::array<double, channel_names>& in_place,
                              const std::vector<Steps>& steps, const BySensor& seeming) {
  BySensor largest = seeming;
  for (const Steps& one : steps) {
    const double most = in_place[one.name] * in_place[one.name];
    if (one.near <= (1 - one.correlation(seeming)) * most) continue;
    const double bound = std::pow(std::max(0.0, 1 - one.near / most), 1 / one.pace);
    largest[one.sensor()] = std::min(largest[one.sensor()], bound);
  }
  return largest;
}

/// The correlation at which neighbours correlate as much in all, over the paces of a sensor, as differences
/// say. \param told  by pace: what they say, and of how many values
double common_correlation(const std::vector<Steps>& told) {
  double sum = 0, values = 0;
  for (const Steps& one : told) sum += one.values * (std::min(2.0, one.ratio) - 1), values += one.values;
  if (!(values > 0)) return 0;
  const auto explained = [&](double phi) {
    double all = 0;
    for (const Steps& one : told) all += one.values * std::pow(phi, one.pace);
    return all;
  };
  const bool one_pace = std::all_of(told.begin(), told.end(), [](const Steps& one) { return one.pace == 1; });
  if (one_pace || sum <= 0 || sum >= values) return sum / values;
  double low = 0, high = 1;
  while (high - low > 1e-12) (explained((low + high) / 2) < sum ? low : high) = (low + high) / 2;
  return low;
}

/// What the ratios of differences say of each sensor's correlation: (1 - phi^2) / (1 - phi) = 1 + phi.
BySensor raw_correlation(const std::vector<Steps>& steps) {
  std::array<std::vector<Steps>, sensors> told;
  for (const Steps& one : steps) {
    // Differences over two readings that exceed twice those over one by more than chance, one in twenty, are
    // of a slope, not of noise.
    const double by_chance = 1.64 * correlation_deviation(1, one.values);
    if (one.near > 0 && one.ratio <= 2 + by_chance) told[one.sensor()].push_back(one);
  }
  BySensor correlation{};
  std::transform(told.begin(), told.end(), correlation.begin(), common_correlation);
  return correlation;
}

/// So many values tell a correlation where the sensor is read fastest: those that are read so, and others as
/// far as theirs changes with it.
BySensor telling_values(const std::vector<Steps>& steps, const BySensor& correlation) {
  BySensor values{};
  for (const Steps& one : steps) {
    const double change = one.pace * std::pow(correlation[one.sensor()], one.pace - 1);
    values[one.sensor()] += std::min(1.0, change * change) * one.values;
  }
  return values;
}

/// Variance of a channel's noise as its steps at one pace show it, for this correlation.
double variance_of(const Steps& steps, double phi) {
  const double straight = steps.near / (1 - phi), curved = steps.curved / ((1 - phi) * (3 - phi));
  return steps.ratio > 2 && curved > 0 ? std::min(straight, curved) : straight;
}

}  // namespace

double correlation_deviation(double correlation, double values) {
  return (1.4 + 0.8 * correlation) / std::sqrt(values);
}

double at_pace(const Series& series, const BySensor& correlation, const ForgetsWithTime& with_time) {
  const double fastest = of(series.channel, correlation);
  return with_time[static_cast<std::size_t>(series.channel.sensor())] ? std::pow(fastest, series.pace)
                                                                      : fastest;
}

namespace {

/// What the likelihood of first-order autoregressive noise takes of a series: sums of its squares and of the
/// products of neighbours.
struct Products {
  const Series* series;
  double before = 0, after = 0, both = 0;

  /// Squares of the innovations, in the variance of the noise.
  [[nodiscard]] double innovations(double phi) const {
    return (after - 2 * phi * both + phi * phi * before) / (1 - phi * phi);
  }
  [[nodiscard]] double values() const { return static_cast<double>(series->readings.size()) - 1; }
};

/// Of what is not slow: a gap is, in some runs and not in others.
std::vector<Products> products_of(const Measurements& measurements, const std::vector<double>& residual,
                                  Sensor sensor) {
  std::vector<Products> all;
  for (const Series& series : measurements.series()) {
    const std::size_t count = series.readings.size();
    if (series.channel.sensor() != sensor || count < 2) continue;
    const auto later = static_cast<Eigen::Index>(count) - 1;
    Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(residual.data() + series.first, later + 1);
    for (std::size_t k = 0; k < slow_components(count); ++k) {
      const Eigen::VectorXd wave = cosine_wave(count, k);
      values -= wave.dot(values) * wave;
    }
    all.push_back({&series, values.head(later).squaredNorm(), values.tail(later).squaredNorm(),
                   values.head(later).dot(values.tail(later))});
  }
  return all;
}

/// Log-likelihood, largest over the scales of the channels, of noise that correlates so where it is read
/// fastest.
double log_likelihood(const std::vector<Products>& all, double fastest, bool with_time) {
  std::array<double, channel_names> squares{}, values{};
  double log = 0;
  for (const Products& one : all) {
    const double phi = with_time ? std::pow(fastest, one.series->pace) : fastest;
    const auto c = static_cast<std::size_t>(one.series->channel.name);
    squares[c] += one.innovations(phi);
    values[c] += one.values();
    log -= one.values() * std::log(1 - phi * phi) / 2;
  }
  for (std::size_t c = 0; c < channel_names; ++c)
    if (squares[c] > 0) log -= values[c] * std::log(squares[c] / values[c]) / 2;
  return log;
}

/// The same, largest over the correlation as well: over memories from half a reading to a thousand.
double log_likelihood(const std::vector<Products>& all, bool with_time) {
  double best = log_likelihood(all, 0, with_time);
  for (double memory = 0.5; memory < 1000; memory *= 1.1)
    best = std::max(best, log_likelihood(all, std::exp(-1 / memory), with_time));
  return best;
}

}  // namespace

ForgetsWithTime forgets_with_time(const Measurements& measurements, const std::vector<double>& residual) {
  ForgetsWithTime with_time{};
  const std::vector<Series>& series = measurements.series();
  if (std::all_of(series.begin(), series.end(), [](const Series& one) { return one.pace == 1; }))
    return with_time;
  for (std::size_t k = 0; k < sensors; ++k) {
    const std::vector<Products> all = products_of(measurements, residual, static_cast<Sensor>(k));
    with_time[k] = log_likelihood(all, true) > log_likelihood(all, false);
  }
  return with_time;
}

namespace {

/// Standard deviations of the channels, for these correlations: the mean over the paces.
std::array<double, channel_names> scales_of(const std::vector<Steps>& steps, const BySensor& correlation) {
  std::array<double, channel_names> variance{}, values{}, scale{1, 1, 1, 1, 1};
  for (const Steps& one : steps) {
    if (!(one.near > 0)) continue;
    variance[one.name] += one.values * (variance_of(one, one.correlation(correlation)) + one.rounded);
    values[one.name] += one.values;
  }
  for (std::size_t c = 0; c < channel_names; ++c)
    if (values[c] > 0) scale[c] = std::sqrt(variance[c] / values[c]);
  return scale;
}

RawNoise raw_noise(const Measurements& measurements, const std::vector<double>& residual,
                   const std::vector<Steps>& steps) {
  RawNoise noise;
  for (const Steps& one : steps) noise.values[one.name] += one.values;
  for (std::size_t c = 0; c < channel_names; ++c)
    noise.largest_in_place[c] = largest_in_place(measurements, residual, all_names[c]);
  noise.correlation = raw_correlation(steps);
  BySensor seeming{};
  for (std::size_t k = 0; k < sensors; ++k) {
    noise.largest_correlation[k] = largest_correlation(measurements, steps, static_cast<Sensor>(k));
    seeming[k] = std::clamp(noise.correlation[k], 0.0, noise.largest_correlation[k]);
  }
  const BySensor taken = correlation_in_place(noise.largest_in_place, steps, seeming);
  for (std::size_t k = 0; k < sensors; ++k)
    if (taken[k] < seeming[k]) noise.largest_correlation[k] = taken[k];
  noise.scale = scales_of(steps, taken);
  return noise;
}

}  // namespace

RawNoise raw_noise(const Measurements& measurements, const std::vector<double>& residual) {
  return raw_noise(measurements, residual,
                   all_steps(measurements, residual, forgets_with_time(measurements, residual)));
}

NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual) {
  return estimate_noise(measurements, residual, forgets_with_time(measurements, residual));
}

NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual,
                          const ForgetsWithTime& with_time) {
  const std::vector<Steps> steps = all_steps(measurements, residual, with_time);
  const RawNoise raw = raw_noise(measurements, residual, steps);
  NoiseModel noise;
  noise.with_time = with_time;
  BySensor taken{};
  for (std::size_t k = 0; k < sensors; ++k)
    taken[k] = std::clamp(raw.correlation[k], 0.0, raw.largest_correlation[k]);
  const BySensor values = telling_values(steps, taken);
  // The estimate's variance is about 1/values.
  constexpr double prior = 1 / (beliefs::correlation_spread * beliefs::correlation_spread);
  for (std::size_t k = 0; k < sensors; ++k)
    noise.correlation[k] =
        std::clamp(values[k] / (values[k] + prior) * raw.correlation[k], 0.0, raw.largest_correlation[k]);
  const std::array<double, channel_names> scales = scales_of(steps, noise.correlation);
  for (std::size_t c = 0; c < channel_names; ++c) {
    const auto k = static_cast<std::size_t>(Channel{all_names[c]}.sensor());
    // What is declared is of the sensor, before its readings are rounded.
    const double declared = std::hypot(1.0, rounding(measurements, all_names[c]));
    noise.scale[c] = declared;
    if (raw.values[c] > 0) noise.scale[c] *= with_prior(scales[c] / declared, raw.values[c] / 2);
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
                                                       const NoiseModel& estimated) {
  const std::vector<Steps> steps = all_steps(measurements, residual, estimated.with_time);
  const BySensor& correlation = estimated.correlation;
  const BySensor values = telling_values(steps, correlation),
                 largest = raw_noise(measurements, residual, steps).largest_correlation;
  std::array<PossibleCorrelation, 2> all{{{{}, 0.2220759}, {{}, 0.0112574}}};
  constexpr std::array<double, 2> deviations{1.3556262, 2.8569700};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < sensors; ++k)
      if (values[k] > 0)
        all[i].value[k] =
            std::clamp(correlation[k] + deviations[i] * correlation_deviation(correlation[k], values[k]), 0.0,
                       largest[k]);
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
                 noise.of(series.channel), noise.correlation_of(series));
  }
  return white;
}

}  // namespace plumbline::diagnose
