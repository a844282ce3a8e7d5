#include "diagnose/inference/hum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/least_squares.hpp"
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
  return LeastSquares(waves).solve(values);
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

/// Frequency a reading below which a tone of so many readings is slow.
double slowest_tone(std::size_t count) {
  return (static_cast<double>(slow_components(count)) / 2 + 1) / static_cast<double>(count);
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
  const double slowest = slowest_tone(count);
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

/// A tone that is known from another run, where it is slow in this one: once around at least, as loud as
/// there within a factor of two, and not by chance.
std::optional<Hum> known_tone(const Series& series, const Series& heard_in, const Hum& heard,
                              const Eigen::VectorXd& values, double level) {
  constexpr int looks = 9;  // within half an ordinate of the run where it was heard, to either side
  const auto m = static_cast<double>(series.readings.size());
  const double ratio = series.interval / heard_in.interval;
  const double off = 0.5 / static_cast<double>(heard_in.readings.size());
  const double middle = values.mean(), energy = (values.array() - middle).square().sum();
  double least = energy;
  Hum found = heard;
  for (int i = 0; i < looks; ++i) {
    const double frequency = ratio * (1 / heard.period + off * (2.0 * i / (looks - 1) - 1));
    if (!(frequency * m > 1) || !(frequency < slowest_tone(series.readings.size()))) continue;
    Eigen::MatrixX3d waves(values.size(), 3);
    waves << tone(series.readings.size(), frequency), Eigen::VectorXd::Ones(values.size());
    const Eigen::Vector3d size = LeastSquares(waves).solve(values);
    const double left = (values - waves * size).squaredNorm();
    if (left < least) least = left, found = {heard.series, 1 / frequency, size(0), size(1)};
  }
  const double chance = looks * std::pow(least / energy, (m - 3) / 2);
  const double louder = found.rms() / heard.rms();
  if (!(chance < level) || !(louder > 0.5 && louder < 2)) return std::nullopt;
  return found;
}

/// Adds to the tones that were heard in some run those that others of its channel then have too.
void add_known(const Measurements& measurements, const std::vector<double>& residual, double level,
               std::vector<Hum>& all) {
  const std::vector<Hum> heard = all;
  const std::vector<Series>& series = measurements.series();
  for (std::size_t s = 0; s < series.size(); ++s) {
    const auto is_here = [&](const Hum& one) { return one.series == s; };
    if (!long_enough(series[s]) || std::any_of(heard.begin(), heard.end(), is_here)) continue;
    for (const Hum& one : heard) {
      const Series& there = series[one.series];
      if (there.channel != series[s].channel || !(there.interval > 0 && series[s].interval > 0)) continue;
      std::optional<Hum> found = known_tone(series[s], there, one, values_of(series[s], residual), level);
      if (!found) continue;
      found->series = s;
      all.push_back(*found);
      break;
    }
  }
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
  add_known(measurements, residual, level, all);
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
