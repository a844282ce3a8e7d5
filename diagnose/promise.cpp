#include "diagnose/promise.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

struct Linear {
  Eigen::VectorXd residual;  ///< whitened
  Eigen::MatrixXd slope;     ///< its derivative by each parameter
};

Eigen::VectorXd white(const Measurements& measurements, const std::vector<double>& values,
                      const NoiseModel& noise) {
  const std::vector<double> result = whiten(measurements, values, noise);
  return Eigen::Map<const Eigen::VectorXd>(result.data(), static_cast<Eigen::Index>(result.size()));
}

std::optional<Linear> linearised(const Experiment& experiment, const Measurements& measurements,
                                 const Candidate& candidate, const std::vector<double>& parameters,
                                 const NoiseModel& noise) {
  const Prediction predicted = predict(experiment, candidate, parameters, true);
  if (!predicted.reached) return std::nullopt;
  Linear linear{white(measurements, measurements.residual(experiment, predicted), noise), {}};
  linear.slope.resize(linear.residual.size(), static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    linear.slope.col(static_cast<Eigen::Index>(p)) =
        -white(measurements, measurements.in_sigmas(predicted.sensitivity[p]), noise);
  }
  if (!linear.residual.allFinite() || !linear.slope.allFinite()) return std::nullopt;
  return linear;
}

/// The step that minimises Huber's loss of the linear model, by reweighting.
Eigen::VectorXd robust_step(const Linear& linear, double bound) {
  const Eigen::VectorXd norm = linear.slope.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd unit = linear.slope * norm.cwiseInverse().asDiagonal();
  Eigen::VectorXd step = Eigen::VectorXd::Zero(unit.cols());
  for (int round = 0; round < 4; ++round) {
    const Eigen::ArrayXd left = (linear.residual + unit * step).array().abs();
    const Eigen::VectorXd weight = (bound / left.max(bound)).matrix();
    const Eigen::MatrixXd weighted = weight.asDiagonal() * unit;
    Eigen::MatrixXd normal = unit.transpose() * weighted;
    normal.diagonal().array() += 1e-9;  // columns that do nothing
    step = -normal.ldlt().solve(weighted.transpose() * linear.residual);
  }
  return step.cwiseQuotient(norm);
}

}  // namespace

std::optional<Promise> promise(const Experiment& experiment, const Measurements& measurements,
                               const Fit& base, const Fit& alone, const std::vector<double>& beginning,
                               const FitSettings& settings) {
  Promise result{base.candidate, base.parameters, 0};
  result.candidate.effects.push_back(alone.candidate.effects.front());
  const bool smooth = std::all_of(beginning.begin(), beginning.end(), [](double v) { return v == 0; });
  const std::vector<double>& tail = smooth ? beginning : alone.parameters;
  result.start.insert(result.start.end(), tail.begin(), tail.end());
  const std::optional<Linear> linear =
      linearised(experiment, measurements, result.candidate, result.start, settings.noise);
  if (!linear) return std::nullopt;
  Eigen::VectorXd step = robust_step(*linear, settings.outlier_bound);
  const std::vector<ParameterRange> ranges = parameter_ranges(experiment, result.candidate);
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const auto k = static_cast<Eigen::Index>(p);
    const double moved = std::clamp(result.start[p] + step(k), ranges[p].low, ranges[p].high);
    step(k) = moved - result.start[p];
    result.start[p] = moved;
  }
  for (const double z : linear->residual + linear->slope * step)
    result.cost += huber(z, settings.outlier_bound);
  return result;
}

}  // namespace plumbline
