#include "diagnose/inference/noise.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Variance by Huber's proposal 2: squares are cut at (2.5 s)^2 and the mean is corrected for the cut. Nearly
/// as efficient as the plain variance, and a few percent of outliers move it by a few percent.
double robust_variance(const std::vector<double>& differences) {
  constexpr double cut = 2.5;
  constexpr double mean_of_cut_square = 0.97756;  // E min(z^2, 2.5^2) for a standard normal z
  std::vector<double> sizes(differences.size());
  std::transform(differences.begin(), differences.end(), sizes.begin(), [](double d) { return std::abs(d); });
  constexpr double normal_mad = 0.6745;  // median of |z|
  double variance = std::pow(median(sizes) / normal_mad, 2);
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

/// Differences of values `lag` apart, of all series of one sensor.
std::vector<double> differences(const Measurements& measurements, const std::vector<double>& residual,
                                Sensor sensor, std::size_t lag) {
  std::vector<double> result;
  for (const Series& series : measurements.series()) {
    if (series.channel.sensor() != sensor) continue;
    for (std::size_t i = lag; i < series.readings.size(); ++i)
      result.push_back(residual[series.first + i] - residual[series.first + i - lag]);
  }
  return result;
}

constexpr std::array<Sensor, 3> sensors{Sensor::position, Sensor::force, Sensor::angle};

/// Median of the up to five values around place i of a series.
double local_median(const Series& series, const std::vector<double>& residual, std::size_t i) {
  const std::size_t count = series.readings.size();
  const std::size_t width = std::min<std::size_t>(5, count);
  const std::size_t from = std::min(i >= 2 ? i - 2 : 0, count - width);
  const auto begin = residual.begin() + static_cast<std::ptrdiff_t>(series.first + from);
  return median(std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(width)));
}

/// Combines a measured logarithm of a scale with its prior, log-normal with a spread of 0.25: 1.5 either way
/// is then 1.6 of its deviations.
double with_prior(double scale, double values) {
  constexpr double spread = 0.25;
  const double information = values;  // the variance of ln s from m differences is about 1/m
  const double log_scale = std::log(scale) * information / (information + 1 / (spread * spread));
  return std::exp(std::clamp(log_scale, -std::log(largest_scale), std::log(largest_scale)));
}

}  // namespace

std::vector<bool> outliers(const Measurements& measurements, const std::vector<double>& residual) {
  std::array<double, 3> scale{1.0, 1.0, 1.0};
  for (const Sensor sensor : sensors) {
    const std::vector<double> steps = differences(measurements, residual, sensor, 1);
    if (!steps.empty()) scale[static_cast<std::size_t>(sensor)] = std::sqrt(robust_variance(steps) / 2);
  }
  constexpr double limit = 5;  // one false mark in a million readings of normal noise
  std::vector<bool> marked(residual.size(), false);
  for (const Series& series : measurements.series()) {
    const double tolerance =
        limit * std::max(scale[static_cast<std::size_t>(series.channel.sensor())], 1 / largest_scale);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const double value = residual[series.first + i];
      marked[series.first + i] =
          series.readings.size() >= 5 && std::abs(value - local_median(series, residual, i)) > tolerance;
    }
  }
  return marked;
}

std::vector<double> without_outliers(const Measurements& measurements, const std::vector<double>& residual) {
  const std::vector<bool> marked = outliers(measurements, residual);
  std::vector<double> clean = residual;
  for (const Series& series : measurements.series()) {
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      if (marked[series.first + i]) clean[series.first + i] = local_median(series, residual, i);
  }
  return clean;
}

RawNoise raw_noise(const Measurements& measurements, const std::vector<double>& residual) {
  RawNoise noise;
  double ratio = 0, weight = 0;
  std::array<double, 3> step{};
  for (const Sensor sensor : sensors) {
    const auto s = static_cast<std::size_t>(sensor);
    const std::vector<double> near = differences(measurements, residual, sensor, 1);
    const std::vector<double> far = differences(measurements, residual, sensor, 2);
    noise.values[s] = static_cast<double>(near.size());
    if (near.empty() || far.empty()) continue;
    step[s] = robust_variance(near);
    if (!(step[s] > 0)) continue;
    ratio += noise.values[s] * robust_variance(far) / step[s];
    weight += noise.values[s];
  }
  // (1 - phi^2) / (1 - phi) = 1 + phi
  noise.correlation = weight > 0 ? ratio / weight - 1 : 0.0;
  const double phi = std::clamp(noise.correlation, 0.0, largest_correlation);
  for (std::size_t s = 0; s < sensors.size(); ++s)
    if (step[s] > 0) noise.scale[s] = std::sqrt(step[s] / (2 * (1 - phi)));
  return noise;
}

NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual) {
  const RawNoise raw = raw_noise(measurements, residual);
  double values = 0;
  for (const double v : raw.values) values += v;
  NoiseModel noise;
  // The estimate's variance is about 1/values; the prior's spread, 0.3, makes 0.6 a rare but possible
  // correlation.
  const double weight = values / (values + 1 / (0.3 * 0.3));
  noise.correlation = std::clamp(weight * raw.correlation, 0.0, largest_correlation);
  const double taken = std::clamp(raw.correlation, 0.0, largest_correlation);
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    const double scale = raw.scale[s] * std::sqrt((1 - taken) / (1 - noise.correlation));
    noise.scale[s] = raw.values[s] > 0 ? with_prior(scale, raw.values[s] / 2) : 1.0;
  }
  return noise;
}

std::vector<double> whiten(const Measurements& measurements, const std::vector<double>& residual,
                           const NoiseModel& noise) {
  std::vector<double> white(residual.size());
  const double phi = noise.correlation;
  const double innovation = std::sqrt(1 - phi * phi);
  for (const Series& series : measurements.series()) {
    const double scale = noise.of(series.channel.sensor());
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const double value = residual[series.first + i];
      white[series.first + i] =
          i == 0 ? value / scale : (value - phi * residual[series.first + i - 1]) / (scale * innovation);
    }
  }
  return white;
}

}  // namespace plumbline::diagnose
