#include "diagnose/noise/gap.hpp"

#include <algorithm>
#include <boost/math/distributions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "diagnose/noise/local_noise.hpp"
#include "diagnose/noise/outliers.hpp"
#include "diagnose/noise/slow.hpp"

namespace plumbline::diagnose {
namespace {

/// Low-frequency energy of each series in units of what the noise model expects of it.
struct Energy {
  std::vector<double> value;
  double whole = 0;  ///< of all frequencies, all series

  [[nodiscard]] double total() const {
    double sum = 0;
    for (const double v : value) sum += v;
    return sum;
  }
};

/// Spectrum of first-order autoregressive noise of unit variance.
double spectrum(double angle, double phi) {
  return (1 - phi * phi) / (1 + phi * phi - 2 * phi * std::cos(angle));
}

Energy slow_energy(const Measurements& measurements, const std::vector<double>& residual,
                   const NoiseModel& noise) {
  Energy energy;
  for (const Series& series : measurements.series()) {
    const std::size_t m = series.readings.size();
    const double scale = noise.of(series.channel);
    const Eigen::Map<const Eigen::VectorXd> values(residual.data() + series.first,
                                                   static_cast<Eigen::Index>(m));
    double sum = 0;
    for (std::size_t k = 0; k < slow_components(m); ++k) {
      const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(m);
      const double component = cosine_wave(m, k).dot(values) / scale;
      sum += component * component / spectrum(angle, noise.correlation_of(series));
    }
    energy.value.push_back(sum);
    for (std::size_t i = series.first; i < series.first + m; ++i)
      energy.whole += std::pow(residual[i] / scale, 2);
  }
  return energy;
}

/// Noise for every series, each from random numbers of its own: what is drawn does not depend on the order of
/// the runs.
class Simulation {
 public:
  /// \param local  by value, over what the noise model says
  Simulation(const Measurements& measurements, const std::vector<double>& local)
      : measurements_(measurements), local_(local) {
    for (const Series& series : measurements.series()) {
      std::seed_seq seed(series.seed.begin(), series.seed.end());
      random_.emplace_back(seed);
    }
  }

  std::vector<double> draw(const NoiseModel& noise) {
    std::vector<double> residual(measurements_.size());
    for (std::size_t s = 0; s < random_.size(); ++s) {
      const Series& series = measurements_.series()[s];
      const double phi = noise.correlation_of(series), innovation = std::sqrt(1 - phi * phi);
      std::normal_distribution<double> normal;
      double state = normal(random_[s]);
      for (std::size_t i = 0; i < series.readings.size(); ++i) {
        if (i > 0) state = phi * state + innovation * normal(random_[s]);
        residual[series.first + i] = noise.of(series.channel) * local_[series.first + i] * state;
      }
    }
    return residual;
  }

 private:
  const Measurements& measurements_;
  const std::vector<double>& local_;
  std::vector<std::mt19937_64> random_;
};

/// Mean and variance of the statistics when the residual is noise.
struct Null {
  double mean_total = 0, variance_total = 0, mean_whole = 0, variance_whole = 0;
  std::vector<double> mean, variance;
};

/// \param taken  the noise that statistics are reckoned with; else what is estimated of every draw
Null null_distribution(const Measurements& measurements, const std::vector<double>& local,
                       const NoiseModel& noise, const std::optional<NoiseModel>& taken) {
  constexpr int draws = 100;  // the spread is then known to 7 %
  Simulation simulation(measurements, local);
  const std::size_t count = measurements.series().size();
  Null null;
  null.mean.assign(count, 0.0);
  null.variance.assign(count, 0.0);
  double square_total = 0, square_whole = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const std::vector<double> residual = simulation.draw(noise);
    const Energy energy = slow_energy(measurements, residual,
                                      taken ? *taken : estimate_noise(measurements, residual, noise.manner));
    null.mean_total += energy.total() / draws;
    square_total += energy.total() * energy.total() / draws;
    null.mean_whole += energy.whole / draws;
    square_whole += energy.whole * energy.whole / draws;
    for (std::size_t s = 0; s < count; ++s) {
      null.mean[s] += energy.value[s] / draws;
      null.variance[s] += energy.value[s] * energy.value[s] / draws;
    }
  }
  null.variance_total = square_total - null.mean_total * null.mean_total;
  null.variance_whole = square_whole - null.mean_whole * null.mean_whole;
  for (std::size_t s = 0; s < count; ++s) null.variance[s] -= null.mean[s] * null.mean[s];
  return null;
}

/// The noise, were neighbours to correlate by more: what is known of its scale is that of their differences,
/// as long as it is none beyond the declared.
NoiseModel slower(NoiseModel noise, const BySensor& correlation) {
  for (std::size_t c = 0; c < noise.scale.size(); ++c) {
    const Channel channel{static_cast<Channel::Name>(c)};
    const double grown = std::sqrt((1 - noise.correlation_of(channel)) / (1 - of(channel, correlation)));
    noise.scale[c] = std::max(noise.scale[c], std::min(1.0, grown * noise.scale[c]));
  }
  noise.correlation = correlation;
  return noise;
}

/// Upper tail of the gamma distribution with this mean and variance.
double upper_tail(double value, double mean, double variance) {
  const boost::math::gamma_distribution<double> gamma(mean * mean / variance, variance / mean);
  return boost::math::cdf(boost::math::complement(gamma, value));
}

/// How noise may be slower than was estimated: as large as the differences of neighbours then mean, and by
/// chance estimated as it was; or as large as it seems, which draws of it rarely seem.
enum class Slower { larger, as_large };

/// Statistics of noise that is slower than this estimate.
Null null_of_slower(const Measurements& measurements, const std::vector<double>& local,
                    const NoiseModel& estimate, const BySensor& correlation, Slower how) {
  if (how == Slower::larger)
    return null_distribution(measurements, local, slower(estimate, correlation), estimate);
  NoiseModel noise = estimate;
  noise.correlation = correlation;
  return null_distribution(measurements, local, noise, std::nullopt);
}

GapTest tested(const Measurements& measurements, const std::vector<double>& residual, Slower how) {
  std::vector<double> clean = without_outliers(measurements, residual);
  GapTest test;
  test.hum = find_hum(measurements, clean);
  clean = without_hum(measurements, std::move(clean), test.hum);
  test.noise = estimate_noise(measurements, clean);
  const Energy energy = slow_energy(measurements, clean, test.noise);
  const std::vector<double> local = how == Slower::larger ? local_noise(measurements, clean)
                                                          : std::vector<double>(measurements.size(), 1.0);
  test.series_p_value.assign(energy.value.size(), 0.0);
  double mean_total = 0, p_total = 0, p_whole = 0;
  const auto add = [&](const Null& null, double probability) {
    mean_total += probability * null.mean_total;
    p_total += probability * upper_tail(energy.total(), null.mean_total, null.variance_total);
    p_whole += probability * upper_tail(energy.whole, null.mean_whole, null.variance_whole);
    for (std::size_t s = 0; s < energy.value.size(); ++s)
      test.series_p_value[s] += probability * upper_tail(energy.value[s], null.mean[s], null.variance[s]);
  };
  // The tail of what several places give together is longer than that of their mean.
  double estimated = 1;
  for (const auto& [correlation, probability] : larger_correlations(measurements, clean, test.noise)) {
    add(null_of_slower(measurements, local, test.noise, correlation, how), probability);
    estimated -= probability;
  }
  add(null_distribution(measurements, local, test.noise, std::nullopt), estimated);
  test.structure = energy.total() / mean_total;
  const double p_single = static_cast<double>(energy.value.size()) *
                          *std::min_element(test.series_p_value.begin(), test.series_p_value.end());
  // Three looks, so three times the smallest (Bonferroni).
  test.p_value = std::min(1.0, 3 * std::min({p_total, p_single, p_whole}));
  return test;
}

}  // namespace

GapTest test_gap(const Measurements& measurements, const std::vector<double>& residual) {
  return tested(measurements, residual, Slower::larger);
}

double structure_p_value(const Measurements& measurements, const std::vector<double>& residual) {
  return tested(measurements, residual, Slower::as_large).p_value;
}

std::array<double, channel_names> rms_by_name(const Measurements& measurements,
                                              const std::vector<double>& residual) {
  std::array<double, channel_names> squares{}, count{};
  for (const Series& series : measurements.series()) {
    const auto c = static_cast<std::size_t>(series.channel.name);
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      squares[c] += std::pow(residual[series.first + i], 2);
    count[c] += static_cast<double>(series.readings.size());
  }
  for (std::size_t c = 0; c < channel_names; ++c)
    if (count[c] > 0) squares[c] = std::sqrt(squares[c] / count[c]);
  return squares;
}

}  // namespace plumbline::diagnose
