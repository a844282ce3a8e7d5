#include "diagnose/noise/noise_manner.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "diagnose/noise/noise_steps.hpp"
#include "diagnose/noise/spectrum.hpp"

namespace plumbline::diagnose {
namespace {

/// Whether first differences of a sensor tell of more correlation than second ones do, by more than chance.
bool has_slopes(const std::vector<Steps>& steps, std::size_t sensor) {
  constexpr double clearly = 2.5;
  double first = 0, more = 0, values = 0;
  for (const Steps& one : steps) {
    if (one.sensor() != sensor || !one.tells_correlation() || !(one.curved > 0)) continue;
    const double seeming = std::min(2.0, one.ratio) - 1;
    first += one.values * seeming;
    more += one.values * (seeming - one.curved_correlation);
    values += one.values;
  }
  // What they differ by deviates in simulated noise by 0.5 over the root of the values where it does not
  // correlate, 1.7 where it does by a half, and 2.5 by 0.8.
  const double deviation = (0.5 + 2.5 * std::clamp(first / values, 0.0, 1.0)) / std::sqrt(values);
  return values > 0 && more / values > clearly * deviation;
}

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
    const Eigen::VectorXd values =
        Fast(count).part(Eigen::Map<const Eigen::VectorXd>(residual.data() + series.first, later + 1));
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

Manner manner_of(const Measurements& measurements, const std::vector<double>& residual) {
  Manner manner;
  const std::vector<Series>& series = measurements.series();
  const bool several_paces =
      std::any_of(series.begin(), series.end(), [](const Series& one) { return one.pace != 1; });
  for (std::size_t k = 0; k < sensors && several_paces; ++k) {
    const std::vector<Products> all = products_of(measurements, residual, static_cast<Sensor>(k));
    manner.with_time[k] = log_likelihood(all, true) > log_likelihood(all, false);
  }
  const std::vector<Steps> steps = plain_steps(measurements, residual, manner);
  for (std::size_t k = 0; k < sensors; ++k) manner.by_bends[k] = has_slopes(steps, k);
  return manner;
}

}  // namespace plumbline::diagnose
