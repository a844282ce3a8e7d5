#include "diagnose/model/measurement.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "diagnose/bench/median.hpp"

namespace plumbline::diagnose {

namespace {

/// What coarse readings are rounded to: the smallest difference of two values that differ by more than double
/// precision does, where a quarter of them and more repeat; else 0.
double rounding_step(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double same = 1e-9 * std::max(std::abs(values.front()), std::abs(values.back()));
  double smallest = values.back() - values.front();
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step > same)
      smallest = std::min(smallest, step);
    else
      ++repeated;
  }
  return 4 * repeated >= values.size() ? smallest : 0;
}

/// What random numbers for the values of a channel begin with.
std::vector<std::uint32_t> seed_of(const Channel& channel, const std::vector<double>& values) {
  std::vector<std::uint32_t> bits{static_cast<std::uint32_t>(channel.name)};
  for (const double value : values) {
    const auto both = std::bit_cast<std::uint64_t>(value);
    bits.push_back(static_cast<std::uint32_t>(both));
    bits.push_back(static_cast<std::uint32_t>(both >> 32));
  }
  return bits;
}

/// Standard deviation of independent noise whose third differences are in the middle as large as those of the
/// values, which a smooth curve hardly has; infinite where there are too few to say, or most of them repeat.
double roughness(const std::vector<double>& values) {
  constexpr std::size_t few = 12;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (values.size() < few) return unknown;
  std::vector<double> sizes;
  for (std::size_t i = 3; i < values.size(); ++i)
    sizes.push_back(std::abs(values[i] - 3 * values[i - 1] + 3 * values[i - 2] - values[i - 3]));
  const double middle = median(std::move(sizes));
  constexpr double normal_mad = 0.6745, squares = 20;  // 1 + 9 + 9 + 1
  return middle > 0 ? middle / normal_mad / std::sqrt(squares) : unknown;
}

}  // namespace

Measurements::Measurements(const Experiment& experiment) {
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    for (const Channel& channel : run.measured()) {
      Series series{r, channel, channel.sigma(experiment.noise) * run.noise_of_group(), size_, {}, 0, 0, {}};
      for (std::size_t i = 0; i < run.readings.size(); ++i)
        if (!std::isnan(channel.of(run.readings[i]))) series.readings.push_back(i);
      if (series.readings.empty()) continue;
      std::vector<double> values;
      for (const std::size_t i : series.readings) values.push_back(channel.of(run.readings[i]));
      series.roughness = roughness(values) / series.sigma;
      series.seed = seed_of(channel, values);
      series.step = rounding_step(std::move(values)) / series.sigma;
      size_ += series.readings.size();
      series_.push_back(std::move(series));
    }
  }
}

std::vector<double> Measurements::residual(const Experiment& experiment, const Prediction& predicted) const {
  std::vector<double> values = in_sigmas(predicted.runs);
  for (const Series& series : series_) {
    const std::vector<Reading>& measured = experiment.runs[series.run].readings;
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      double& value = values[series.first + i];
      value = series.channel.of(measured[series.readings[i]]) / series.sigma - value;
    }
  }
  return values;
}

std::vector<double> Measurements::in_sigmas(const std::vector<Trace>& traces) const {
  std::vector<double> values;
  values.reserve(size_);
  for (const Series& series : series_) {
    const auto column = traces[series.run].col(column_of(series.channel));
    for (const std::size_t i : series.readings)
      values.push_back(column(static_cast<Eigen::Index>(i)) / series.sigma);
  }
  return values;
}

}  // namespace plumbline::diagnose
