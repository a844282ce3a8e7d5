#include "diagnose/noise/series_tone.hpp"

#include <cmath>
#include <numbers>

#include "diagnose/inference/least_squares.hpp"
#include "diagnose/noise/spectrum.hpp"

namespace plumbline::diagnose {

double Hum::rms() const {
  return std::hypot(cosine, sine) / std::numbers::sqrt2;
}

bool long_enough(const Series& series) {
  return series.readings.size() >= 16;
}

Eigen::VectorXd clock_of(const Series& series) {
  return Eigen::Map<const Eigen::VectorXd>(series.clock.data(),
                                           static_cast<Eigen::Index>(series.clock.size()));
}

Eigen::VectorXd values_of(const Series& series, const std::vector<double>& residual) {
  return Eigen::Map<const Eigen::VectorXd>(residual.data() + series.first,
                                           static_cast<Eigen::Index>(series.readings.size()));
}

Hum tone_of(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency) {
  const Fast fast(static_cast<std::size_t>(values.size()));
  const Eigen::Vector2d size = fast.amplitudes(values, tone(clock, frequency));
  return {0, 1 / frequency, size(0), size(1)};
}

Slow slow_tone(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency, bool round) {
  const Eigen::Index columns = round ? 3 : 2;
  Eigen::MatrixXd waves(values.size(), columns);
  waves.leftCols(2) = tone(clock, frequency);
  if (round) waves.col(2).setOnes();
  const Eigen::VectorXd size = LeastSquares(waves).solve(values);
  const double energy = (values.array() - (round ? values.mean() : 0)).square().sum(),
               left = (values - waves * size).squaredNorm();
  return {{0, 1 / frequency, size(0), size(1)},
          left > 0 ? static_cast<double>(values.size() - columns) / 2 * std::log(energy / left) : 0};
}

Eigen::VectorXd wave_of(const Series& series, const Hum& one) {
  return tone(clock_of(series), 1 / one.period) * Eigen::Vector2d(one.cosine, one.sine);
}

std::vector<double> without_hum(const Measurements& measurements, std::vector<double> residual,
                                const std::vector<Hum>& hum) {
  for (const Hum& one : hum) {
    const Series& series = measurements.series()[one.series];
    Eigen::Map<Eigen::VectorXd> values(residual.data() + series.first,
                                       static_cast<Eigen::Index>(series.readings.size()));
    values -= wave_of(series, one);
  }
  return residual;
}

}  // namespace plumbline::diagnose
