#include "diagnose/inference/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/inference/least_squares.hpp"
#include "diagnose/inference/slow.hpp"

namespace plumbline::diagnose {

namespace {

/// Innovations of noise whose neighbours correlate: without them, slow noise would look like a line.
Eigen::MatrixXd innovations(const Eigen::MatrixXd& columns, double correlation) {
  const Eigen::Index rest = columns.rows() - 1;
  return columns.bottomRows(rest) - correlation * columns.topRows(rest);
}

}  // namespace

Eigen::MatrixX2d tone(const Eigen::VectorXd& clock, double frequency) {
  const Eigen::ArrayXd angle = clock.array() * (2 * std::numbers::pi * frequency);
  Eigen::MatrixX2d waves(clock.size(), 2);
  waves << angle.cos(), angle.sin();
  return waves;
}

Fast::Fast(std::size_t count)
    : slow_(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(slow_components(count))) {
  for (Eigen::Index k = 0; k < slow_.cols(); ++k)
    slow_.col(k) = cosine_wave(count, static_cast<std::size_t>(k));
}

Eigen::MatrixXd Fast::part(const Eigen::MatrixXd& columns) const {
  return columns - slow_ * (slow_.transpose() * columns);
}

Eigen::Vector2d Fast::amplitudes(const Eigen::VectorXd& values, const Eigen::MatrixX2d& waves) const {
  return LeastSquares(part(waves)).solve(part(values));
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

namespace {

/// Values of which tones may explain a share.
class Whitened {
 public:
  Whitened(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double correlation)
      : fast_(static_cast<std::size_t>(values.size())),
        clock_(clock),
        correlation_(correlation),
        white_(innovations(fast_.part(values), correlation)),
        energy_(white_.squaredNorm()) {}

  [[nodiscard]] double share(double frequency) const {
    if (!(energy_ > 0)) return 0;
    const Eigen::MatrixXd waves = innovations(fast_.part(tone(clock_, frequency)), correlation_);
    return (waves * LeastSquares(waves).solve(white_)).squaredNorm() / energy_;
  }

 private:
  Fast fast_;
  const Eigen::VectorXd& clock_;
  double correlation_;
  Eigen::VectorXd white_;
  double energy_;
};

}  // namespace

double tone_share(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency,
                  double correlation) {
  return Whitened(values, clock, correlation).share(frequency);
}

Eigen::VectorXd tone_shares(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double correlation) {
  const auto count = static_cast<std::size_t>(values.size());
  const Whitened white(values, clock, correlation);
  Eigen::VectorXd shares(static_cast<Eigen::Index>(std::ceil(looks_an_ordinate * ordinates(count))));
  for (Eigen::Index look = 0; look < shares.size(); ++look)
    shares(look) = white.share(looked_at(count, look));
  return shares;
}

}  // namespace plumbline::diagnose
