#include "diagnose/inference/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/slow.hpp"

namespace plumbline::diagnose {

namespace {

/// Innovations of noise whose neighbours correlate: without them, slow noise would look like a line.
Eigen::VectorXd innovations(const Eigen::VectorXd& values, double correlation) {
  const Eigen::Index rest = values.size() - 1;
  return values.tail(rest) - correlation * values.head(rest);
}

}  // namespace

Eigen::MatrixX2d tone(const Eigen::VectorXd& clock, double frequency) {
  const Eigen::ArrayXd angle = clock.array() * (2 * std::numbers::pi * frequency);
  Eigen::MatrixX2d waves(clock.size(), 2);
  waves << angle.cos(), angle.sin();
  return waves;
}

Eigen::Vector2d amplitudes(const Eigen::VectorXd& values, const Eigen::MatrixX2d& waves) {
  return LeastSquares(waves).solve(values);
}

Eigen::VectorXd fast_part(const Eigen::VectorXd& values) {
  Eigen::VectorXd fast = values;
  const auto count = static_cast<std::size_t>(values.size());
  for (std::size_t k = 0; k < slow_components(count); ++k) {
    const Eigen::VectorXd wave = cosine_wave(count, k);
    fast -= wave * wave.dot(fast);
  }
  return fast;
}

double slowest_tone(std::size_t count) {
  return (static_cast<double>(slow_components(count)) / 2 + 1) / static_cast<double>(count);
}

double looked_at(std::size_t count, Eigen::Index look) {
  return slowest_tone(count) + static_cast<double>(look) / (looks_an_ordinate * static_cast<double>(count));
}

double ordinates(std::size_t count) {
  return (0.5 - slowest_tone(count)) * static_cast<double>(count);
}

Eigen::VectorXd tone_shares(const Eigen::VectorXd& fast, const Eigen::VectorXd& clock, double correlation) {
  const auto count = static_cast<std::size_t>(fast.size());
  const Eigen::VectorXd white = innovations(fast, correlation);
  const double energy = white.squaredNorm();
  Eigen::VectorXd shares =
      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(std::ceil(looks_an_ordinate * ordinates(count))));
  for (Eigen::Index look = 0; look < shares.size() && energy > 0; ++look) {
    const Eigen::MatrixX2d waves = tone(clock.head(white.size()), looked_at(count, look));
    shares(look) = (waves * amplitudes(white, waves)).squaredNorm() / energy;
  }
  return shares;
}

}  // namespace plumbline::diagnose
