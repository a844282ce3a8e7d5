#include "diagnose/noise/noise_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace plumbline::diagnose {

const ChannelNoise& NoiseEstimate::of(const Channel& channel) const {
  return *std::find_if(channels.begin(), channels.end(),
                       [&](const ChannelNoise& one) { return one.channel == channel; });
}

double NoiseEstimate::scale_of(Channel::Name name) const {
  double largest = 0;
  for (const ChannelNoise& one : channels)
    if (one.channel.name == name) largest = std::max(largest, one.scale);
  return largest > 0 ? largest : 1;
}

VectorXd NoiseEstimate::sigma(const Measurements& measurements) const {
  VectorXd result = shape.relative;
  for (const Block& block : measurements.blocks())
    result.segment(block.first, block.count) *= of(block.channel).scale;
  return result;
}

MatrixXd NoiseEstimate::whitened(const Measurements& measurements, const MatrixXd& columns) const {
  MatrixXd result = MatrixXd::Zero(columns.rows(), columns.cols());
  for (const Series& series : measurements.series()) {
    const ChannelNoise& noise = of(series.channel);
    Eigen::Index last = -1;
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(series.first + i);
      if (shape.outlier[series.first + i]) continue;
      double rho = 0;
      if (last >= 0) {
        const std::size_t before = static_cast<std::size_t>(last) - series.first;
        rho = std::pow(noise.correlation, static_cast<double>(series.readings[i] - series.readings[before]));
        result.row(row) = -rho / shape.relative(last) * columns.row(last);
      }
      result.row(row) += columns.row(row) / shape.relative(row);
      result.row(row) /= noise.scale * std::sqrt(1 - rho * rho);
      last = row;
    }
  }
  return result;
}

VectorXd innovations(const VectorXd& values, double scale, double correlation) {
  VectorXd result = values / scale;
  const Eigen::Index rest = values.size() - 1;
  if (rest > 0)
    result.tail(rest) = (values.tail(rest) - correlation * values.head(rest)) /
                        (scale * std::sqrt(1 - correlation * correlation));
  return result;
}

}  // namespace plumbline::diagnose
