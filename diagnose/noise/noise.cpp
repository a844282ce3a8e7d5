#include "diagnose/noise/noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "diagnose/beliefs.hpp"
#include "diagnose/bench/median.hpp"
#include "diagnose/noise/noise_manner.hpp"
#include "diagnose/noise/noise_steps.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether so many differences of a channel, and of all channels of its sensor, are enough to say that noise
/// is what nobody would believe: the differences of a few are steps of a gap as well.
bool are_enough(double of_channel, double of_sensor) {
  constexpr double enough = 12, together = 16;
  return of_channel >= enough || of_sensor >= together;
}

/// Combines a scale that so many differences show with its prior: log-normal about one, as wide as is
/// believed, or as they themselves ask for, where they are enough.
double with_prior(double scale, double differences, double of_sensor) {
  const double asked = are_enough(differences, of_sensor) ? std::abs(std::log(scale)) : 0;
  const double spread = std::max(beliefs::scale_spread, asked);
  const double information = differences / 2;  // the variance of ln s from m differences is about 2/m
  return std::exp(std::log(scale) * information / (information + 1 / (spread * spread)));
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
double largest_in_place(const Measurements& measurements, const std::vector<double>& residual,
                        Channel::Name name) {
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
double scale_bound(const Measurements& measurements, double in_place, Channel::Name name) {
  constexpr double hidden = 3;
  double rough = 0;
  for (const Series& series : measurements.series())
    if (series.channel.name == name) rough = std::max(rough, series.roughness);
  // What rounds a value alike whenever it comes by shows neither in place nor where readings stand still.
  const double rounded = rounding(measurements, name);
  return std::max(std::hypot(1.0, rounded), std::hypot(std::min(hidden * rough, in_place), rounded));
}

/// Noise of the declared scale whose first differences are no larger than these correlates by 1 - near.
double largest_correlation(const Measurements& measurements, const std::vector<Steps>& steps, Sensor sensor) {
  std::vector<double> lengths;
  for (const Series& series : measurements.series())
    if (series.channel.sensor() == sensor) lengths.push_back(static_cast<double>(series.readings.size()));
  double rough = 0;
  for (const Steps& one : steps)
    if (one.sensor() == place_of(sensor) && one.pace == 1) rough = std::max(rough, one.near);
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
    if (one.tells_correlation()) told[one.sensor()].push_back(one);
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
                   all_steps(measurements, residual, manner_of(measurements, residual)));
}

NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual) {
  return estimate_noise(measurements, residual, manner_of(measurements, residual));
}

NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual,
                          const Manner& manner) {
  const std::vector<Steps> steps = all_steps(measurements, residual, manner);
  const RawNoise raw = raw_noise(measurements, residual, steps);
  NoiseModel noise;
  noise.manner = manner;
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
  BySensor of_sensor{};
  for (std::size_t c = 0; c < channel_names; ++c)
    of_sensor[place_of(Channel{all_names[c]}.sensor())] += raw.values[c];
  for (std::size_t c = 0; c < channel_names; ++c) {
    const auto k = place_of(Channel{all_names[c]}.sensor());
    // What is declared is of the sensor, before its readings are rounded.
    const double declared = std::hypot(1.0, rounding(measurements, all_names[c]));
    noise.scale[c] = declared;
    if (raw.values[c] > 0) noise.scale[c] *= with_prior(scales[c] / declared, raw.values[c], of_sensor[k]);
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
  const std::vector<Steps> steps = all_steps(measurements, residual, estimated.manner);
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
