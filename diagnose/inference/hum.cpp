#include "diagnose/inference/hum.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/slow.hpp"

namespace plumbline::diagnose {
namespace {

/// Cosine and sine of a tone, one row a reading.
Eigen::MatrixX2d tone(std::size_t count, double frequency) {
  const auto rows = static_cast<Eigen::Index>(count);
  const Eigen::ArrayXd angle =
      Eigen::ArrayXd::LinSpaced(rows, 0, static_cast<double>(rows - 1)) * (2 * std::numbers::pi * frequency);
  Eigen::MatrixX2d waves(rows, 2);
  waves << angle.cos(), angle.sin();
  return waves;
}

Eigen::Vector2d amplitudes(const Eigen::VectorXd& values, const Eigen::MatrixX2d& waves) {
  return waves.completeOrthogonalDecomposition().solve(values);
}

/// What is left of values without their slow components.
Eigen::VectorXd fast_part(const Eigen::VectorXd& values) {
  Eigen::VectorXd fast = values;
  const auto count = static_cast<std::size_t>(values.size());
  for (std::size_t k = 0; k < slow_components(count); ++k) {
    const Eigen::VectorXd wave = cosine_wave(count, k);
    fast -= wave * wave.dot(fast);
  }
  return fast;
}

/// Innovations of noise whose neighbours correlate: without them, slow noise would look like a line.
Eigen::VectorXd innovations(const Eigen::VectorXd& values, double correlation) {
  const Eigen::Index rest = values.size() - 1;
  return values.tail(rest) - correlation * values.head(rest);
}

/// The loudest tone in these values, and the chance that noise alone has one as loud.
struct Loudest {
  Hum tone;
  double chance;
};

Loudest loudest(const Eigen::VectorXd& values, double correlation) {
  constexpr double per_ordinate = 4;  // frequencies looked at: a line between two ordinates loses nothing
  const auto count = static_cast<std::size_t>(values.size());
  const Eigen::VectorXd fast = fast_part(values), white = innovations(fast, correlation);
  const auto m = static_cast<double>(count);
  const double slowest = (static_cast<double>(slow_components(count)) / 2 + 1) / m;
  double best = 0, at = slowest;
  const auto looks = static_cast<int>(std::ceil((0.5 - slowest) * per_ordinate * m));
  for (int i = 0; i < looks; ++i) {
    const double frequency = slowest + i / (per_ordinate * m);
    const Eigen::MatrixX2d waves = tone(count - 1, frequency);
    const double explained = (waves * amplitudes(white, waves)).squaredNorm();
    if (explained > best) best = explained, at = frequency;
  }
  const Eigen::Vector2d size = amplitudes(fast, tone(count, at));
  // Fisher: with n ordinates the largest share g of the energy has P(g > x) < n (1 - x)^(n - 1); looking
  // between the ordinates finds no more than twice as often.
  const double ordinates = (0.5 - slowest) * m, energy = white.squaredNorm();
  const double share = energy > 0 ? best / energy : 0;
  return {{0, 1 / at, size(0), size(1)}, 2 * ordinates * std::pow(1 - share, ordinates - 1)};
}

/// A spectrum of fewer ordinates has no line.
bool long_enough(const Series& series) {
  return series.readings.size() >= 16;
}

Eigen::VectorXd values_of(const Series& series, const std::vector<double>& residual) {
  return Eigen::Map<const Eigen::VectorXd>(residual.data() + series.first,
                                           static_cast<Eigen::Index>(series.readings.size()));
}

/// By how much neighbours correlate beside the loudest tone of each series, be it noise or not.
double correlation_beside_tones(const Measurements& measurements, const std::vector<double>& residual) {
  std::vector<Hum> all;
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    if (!long_enough(measurements.series()[s])) continue;
    all.push_back(loudest(values_of(measurements.series()[s], residual), 0).tone);
    all.back().series = s;
  }
  return estimate_noise(measurements, without_hum(measurements, residual, all)).correlation;
}

}  // namespace

double Hum::rms() const {
  return std::hypot(cosine, sine) / std::numbers::sqrt2;
}

std::vector<Hum> find_hum(const Measurements& measurements, const std::vector<double>& residual) {
  constexpr int most = 2;
  constexpr double level = 1e-3;
  std::vector<Hum> all;
  const double correlation = correlation_beside_tones(measurements, residual);
  for (std::size_t s = 0; s < measurements.series().size(); ++s) {
    const Series& series = measurements.series()[s];
    if (!long_enough(series)) continue;
    Eigen::VectorXd values = values_of(series, residual);
    for (int i = 0; i < most; ++i) {
      auto [one, chance] = loudest(values, correlation);
      if (!(chance < level) || one.rms() > beliefs::largest_scale) break;
      values -= tone(series.readings.size(), 1 / one.period) * Eigen::Vector2d(one.cosine, one.sine);
      one.series = s;
      all.push_back(one);
    }
  }
  return all;
}

std::vector<double> without_hum(const Measurements& measurements, std::vector<double> residual,
                                const std::vector<Hum>& hum) {
  for (const Hum& one : hum) {
    const Series& series = measurements.series()[one.series];
    Eigen::Map<Eigen::VectorXd> values(residual.data() + series.first,
                                       static_cast<Eigen::Index>(series.readings.size()));
    values -= tone(series.readings.size(), 1 / one.period) * Eigen::Vector2d(one.cosine, one.sine);
  }
  return residual;
}

}  // namespace plumbline::diagnose
