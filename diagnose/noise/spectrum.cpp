#include "diagnose/noise/spectrum.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "diagnose/inference/least_squares.hpp"
#include "diagnose/noise/slow.hpp"

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
  Whitened(const Eigen::VectorXd& values, double correlation)
      : fast_(static_cast<std::size_t>(values.size())),
        correlation_(correlation),
        white_(innovations(fast_.part(values), correlation)),
        energy_(white_.squaredNorm()) {}

  /// What cosine and sine of a tone explain of them.
  [[nodiscard]] double share(const Eigen::MatrixX2d& waves) const {
    return energy_ > 0 ? explained(innovations(fast_.part(waves), correlation_)) / energy_ : 0;
  }

 private:
  /// Energy in the plane of two waves, by their normal equations: of thousands of looks, a decomposition each
  /// would take half of the time. Twice a reading one of them is nothing, and the other stands alone.
  [[nodiscard]] double explained(const Eigen::MatrixX2d& waves) const {
    const Eigen::Matrix2d gram = waves.transpose() * waves;
    const Eigen::Vector2d along = waves.transpose() * white_;
    constexpr double parallel = 1e-10;
    if (gram.determinant() > parallel * gram(0, 0) * gram(1, 1)) return along.dot(gram.inverse() * along);
    const Eigen::Index longer = gram(0, 0) > gram(1, 1) ? 0 : 1;
    return gram(longer, longer) > 0 ? along(longer) * along(longer) / gram(longer, longer) : 0;
  }

  Fast fast_;
  double correlation_;
  Eigen::VectorXd white_;
  double energy_;
};

}  // namespace

double tone_share(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency,
                  double correlation) {
  return Whitened(values, correlation).share(tone(clock, frequency));
}

Eigen::VectorXd tone_shares(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double correlation) {
  const auto count = static_cast<std::size_t>(values.size());
  const Whitened white(values, correlation);
  Eigen::VectorXd shares(static_cast<Eigen::Index>(std::ceil(looks_an_ordinate * ordinates(count))));
  // From look to look each value of a wave turns by the same angle.
  const auto turned = [&](double frequency) -> Eigen::ArrayXcd {
    const Eigen::MatrixX2d waves = tone(clock, frequency);
    return waves.col(0) + std::complex<double>(0, 1) * waves.col(1);
  };
  Eigen::ArrayXcd wave = turned(looked_at(count, 0));
  const Eigen::ArrayXcd turn = turned(looked_at(count, 1) - looked_at(count, 0));
  Eigen::MatrixX2d waves(values.size(), 2);
  for (Eigen::Index look = 0; look < shares.size(); ++look, wave *= turn) {
    waves << wave.real(), wave.imag();
    shares(look) = white.share(waves);
  }
  return shares;
}

}  // namespace plumbline::diagnose
