#include "diagnose/bench/repeated_readings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

bool equal(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool equal(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](double one, double other) { return equal(one, other); });
}

bool same(const std::vector<Channel>& channels, const Reading& a, const Reading& b) {
  return std::all_of(channels.begin(), channels.end(),
                     [&](const Channel& channel) { return equal(channel.of(a), channel.of(b)); });
}

/// Whether the bench imposed the same at two readings.
bool same_command(const Run& run, const Reading& a, const Reading& b) {
  return same(run.imposed(), a, b) && equal(a.rest, b.rest) && equal(a.covariates, b.covariates);
}

/// The smallest difference between values of a channel: a display shows no smaller one.
double smallest_step(const Run& run, const Channel& channel) {
  std::vector<double> values;
  for (const Reading& reading : run.readings)
    if (std::isfinite(channel.of(reading))) values.push_back(channel.of(reading));
  std::sort(values.begin(), values.end());
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i] > values[i - 1]) step = std::min(step, values[i] - values[i - 1]);
  return step;
}

/// Logarithm of the probability that noise alone makes two readings equal: the density at zero of the
/// difference of two Gaussian values, times the step, channel by channel.
double log_chance(const Run& run, const std::vector<Channel>& measured, const Noise& noise) {
  double sum = 0;
  for (const Channel& channel : measured) {
    const double sigma = channel.sigma(noise);
    if (sigma > 0)
      sum += std::log(std::min(0.5, smallest_step(run, channel) / (2 * std::sqrt(std::numbers::pi) * sigma)));
  }
  return sum;
}

/// Log odds that k of n neighbours are equal since they are repeated, in a share of which any is as probable.
double log_odds_of_repetition(double k, double n, double log_chance) {
  const double share_summed_out = std::lgamma(k + 1) + std::lgamma(n - k + 1) - std::lgamma(n + 2);
  return std::log(priors::uneven_noise / (1 - priors::uneven_noise)) + share_summed_out - k * log_chance -
         (n - k) * std::log1p(-std::exp(log_chance));
}

}  // namespace

Run without_repeated_readings(Run run, const Noise& noise) {
  const std::vector<Channel> measured = run.measured();
  std::vector<std::size_t> kept{0};
  double alike = 0;
  for (std::size_t i = 1; i < run.readings.size(); ++i) {
    const Reading &before = run.readings[i - 1], &here = run.readings[i];
    const bool commanded_alike = same_command(run, before, here);
    alike += commanded_alike;
    if (!commanded_alike || !same(measured, before, here)) kept.push_back(i);
  }
  const double repeated = static_cast<double>(run.readings.size()) - static_cast<double>(kept.size());
  if (repeated < 1 || !(log_odds_of_repetition(repeated, alike, log_chance(run, measured, noise)) > 0))
    return run;
  std::vector<Reading> readings;
  for (const std::size_t i : kept) readings.push_back(std::move(run.readings[i]));
  kept.push_back(run.readings.size());
  run.readings = std::move(readings);
  run.groups.first = std::move(kept);
  return run;
}

}  // namespace plumbline::diagnose
