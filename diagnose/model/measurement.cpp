#include "diagnose/model/measurement.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

#include "diagnose/bench/median.hpp"
#include "diagnose/model/proportional_noise.hpp"
#include "diagnose/model/uneven_noise.hpp"

namespace plumbline::diagnose {
namespace {

/// The largest number of which both are multiples, to so much; zero where that is no larger.
double common_divisor(double one, double other, double tolerance) {
  while (other > tolerance) {
    const double left = std::abs(one - std::round(one / other) * other);
    one = other, other = left;
  }
  return one > 100 * tolerance ? one : 0;
}

/// What readings are rounded to: the largest step of which all their differences are multiples, to more
/// digits than anybody writes; zero where there is none, or the differences are so few that it may be larger.
double rounding_step(const std::vector<double>& values) {
  constexpr std::size_t enough = 8;  // random integers have another divisor than 1 in 1 of 120 cases
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  const double tolerance = 1e-9 * largest;
  double step = 0;
  std::size_t steps = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double difference = std::abs(values[i] - values[i - 1]);
    if (difference <= tolerance) continue;
    step = steps == 0 ? difference : common_divisor(step, difference, tolerance);
    ++steps;
    if (step == 0) return 0;
  }
  return steps >= enough || 4 * (values.size() - 1 - steps) >= values.size() ? step : 0;
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
double roughness(const ThirdDifferences& differences, double proportion) {
  constexpr std::size_t few = 9;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (differences.sizes.size() < few) return unknown;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < differences.sizes.size(); ++i)
    sizes.push_back(differences.sizes[i] / std::hypot(1.0, proportion * differences.levels[i]));
  const double deviation = median_deviation(std::move(sizes));
  if (deviation > 0) return deviation;
  return unknown;
}

double mean_interval(const Run& run, const std::vector<std::size_t>& readings) {
  const double time = run.readings[readings.back()].t - run.readings[readings.front()].t;
  return readings.size() > 1 ? time / static_cast<double>(readings.size() - 1) : 0;
}

std::vector<double> clock_of(const Run& run, const Series& series) {
  std::vector<double> clock;
  for (const std::size_t i : series.readings) {
    const double since = run.readings[i].t - run.readings[series.readings.front()].t;
    clock.push_back(series.interval > 0 ? since / series.interval : static_cast<double>(clock.size()));
  }
  return clock;
}

}  // namespace

Measurements::Measurements(const Experiment& experiment) {
  std::vector<std::vector<double>> all;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    const Run& run = experiment.runs[r];
    for (const Channel& channel : run.measured()) {
      Series series{
          r, channel, channel.sigma(experiment.noise) * run.noise_of_group(), size_, {}, 0, {}, {}, 0, 0, 0,
          1, {}};
      for (std::size_t i = 0; i < run.readings.size(); ++i)
        if (!std::isnan(channel.of(run.readings[i]))) series.readings.push_back(i);
      if (series.readings.empty()) continue;
      series.interval = mean_interval(run, series.readings);
      series.clock = clock_of(run, series);
      std::vector<double> values;
      for (const std::size_t i : series.readings) values.push_back(channel.of(run.readings[i]));
      series.seed = seed_of(channel, values);
      series.step = rounding_step(values) / series.sigma;
      size_ += series.readings.size();
      series_.push_back(std::move(series));
      all.push_back(std::move(values));
    }
  }
  weigh_joints(experiment, all);
  weigh(experiment, all);
}

/// Gives the angles of a joint that scatters more than the others a sigma to match, unless it does because it
/// is bent more than they are: noise in proportion is that of all.
void Measurements::weigh_joints(const Experiment& experiment,
                                const std::vector<std::vector<double>>& values) {
  std::vector<ThirdDifferences> all;
  std::vector<std::size_t> joints;
  for (std::size_t s = 0; s < series_.size(); ++s) {
    const Series& series = series_[s];
    if (series.channel.name != Channel::Name::q) continue;
    const std::vector<bool> evenly = goes_evenly(experiment.runs[series.run], series.readings);
    all.push_back(ThirdDifferences(values[s], series.sigma).where(evenly));
    joints.push_back(series.channel.joint);
  }
  const auto times_beside = [&](double proportion) {
    std::vector<std::vector<double>> sizes(experiment.link_length.size());
    for (std::size_t s = 0; s < all.size(); ++s)
      for (std::size_t i = 0; i < all[s].sizes.size(); ++i)
        sizes[joints[s]].push_back(all[s].sizes[i] / std::hypot(1.0, proportion * all[s].levels[i]));
    return uneven_noise(sizes);
  };
  const std::vector<double> times = times_beside(0);
  const std::vector<double> beside = times_beside(proportional_noise(all));
  const auto stands_out = [](double one) { return one > 1; };
  if (std::none_of(beside.begin(), beside.end(), stands_out)) return;
  for (Series& series : series_) {
    if (series.channel.name != Channel::Name::q) continue;
    series.times = times[series.channel.joint];
    series.sigma *= series.times;
    series.step /= series.times;
  }
}

/// Gives every value its sigma. What scatters in proportion does so in all runs of a channel.
void Measurements::weigh(const Experiment& experiment, const std::vector<std::vector<double>>& values) {
  std::vector<ThirdDifferences> differences;
  std::map<Channel::Name, std::vector<ThirdDifferences>> even;
  for (std::size_t s = 0; s < series_.size(); ++s) {
    const Series& series = series_[s];
    differences.emplace_back(values[s], series.sigma);
    const std::vector<bool> evenly = goes_evenly(experiment.runs[series.run], series.readings);
    even[series.channel.name].push_back(differences.back().where(evenly));
  }
  std::map<Channel::Name, double> proportions;
  for (const auto& [name, all] : even) proportions[name] = proportional_noise(all);
  for (std::size_t s = 0; s < series_.size(); ++s) {
    Series& series = series_[s];
    series.proportion = proportions[series.channel.name];
    for (const double value : values[s])
      series.sigmas.push_back(series.sigma * std::hypot(1.0, series.proportion * value));
    series.roughness = roughness(differences[s], series.proportion);
  }
}

std::vector<double> Measurements::residual(const Experiment& experiment, const Prediction& predicted) const {
  std::vector<double> values = in_sigmas(predicted.runs);
  for (const Series& series : series_) {
    const std::vector<Reading>& measured = experiment.runs[series.run].readings;
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      double& value = values[series.first + i];
      value = series.channel.of(measured[series.readings[i]]) / series.sigmas[i] - value;
    }
  }
  return values;
}

std::vector<double> Measurements::in_sigmas(const std::vector<Trace>& traces) const {
  std::vector<double> values;
  values.reserve(size_);
  for (const Series& series : series_) {
    const auto column = traces[series.run].col(column_of(series.channel));
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      values.push_back(column(static_cast<Eigen::Index>(series.readings[i])) / series.sigmas[i]);
  }
  return values;
}

}  // namespace plumbline::diagnose
