#include "diagnose/inference/likelihood.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

double root_mean_square(const VectorXd& residual, Eigen::Index first, Eigen::Index values,
                        const NoiseShape& shape) {
  double sum = 0, count = 0;
  for (Eigen::Index i = first; i < first + values; ++i)
    if (!shape.outlier[static_cast<std::size_t>(i)]) sum += residual(i) * residual(i), count += 1;
  constexpr double smallest = 1e-3;
  return std::max(smallest, std::sqrt(sum / std::max(1.0, count)));
}

/// By value: one over its noise; zero of outliers.
VectorXd weights(const NoiseShape& shape) {
  VectorXd weight = shape.relative.cwiseInverse();
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (shape.outlier[static_cast<std::size_t>(i)]) weight(i) = 0;
  return weight;
}

/// What a cause outside of the catalogue typically changes: a tenth of what the readings of a channel differ
/// by among themselves.
double typical_of(const Measurements& measurements, const Block& block) {
  const VectorXd readings = measurements.value().segment(block.first, block.count);
  const VectorXd sigma = measurements.sigma().segment(block.first, block.count);
  const VectorXd spread = (readings.array() - readings.mean()) / sigma.array();
  return std::max(
      1.0, priors::typical_outside * std::sqrt(spread.squaredNorm() / static_cast<double>(block.count)));
}

}  // namespace

std::vector<double> log_posterior(const std::vector<double>& log_likelihood,
                                  const std::vector<double>& log_prior) {
  std::vector<double> joint = sum(log_likelihood, log_prior);
  const double all = log_sum(joint);
  for (double& one : joint) one -= all;
  return joint;
}

double expected(const std::vector<double>& log_likelihood, const std::vector<double>& log_prior,
                const std::vector<double>& values) {
  const std::vector<double> posterior = log_posterior(log_likelihood, log_prior);
  double mean = 0;
  for (std::size_t a = 0; a < values.size(); ++a) mean += std::exp(posterior[a]) * values[a];
  return mean;
}

Likelihood::Likelihood(const Measurements& measurements, const CommandStates& states,
                       const Hyperpriors& priors, NoiseShape shape, const VectorXd& nominal_residual)
    : measurements_(measurements),
      states_(states),
      priors_(priors),
      shape_(std::move(shape)),
      nominal_residual_(nominal_residual),
      nominal_size_(root_mean_square(nominal_residual, 0, nominal_residual.size(), shape_)) {
  double log_typical = 0;
  for (const Block& block : measurements.blocks()) {
    typical_.push_back(typical_of(measurements, block));
    const double unit = root_mean_square(nominal_residual, block.first, block.count, shape_);
    log_typical += static_cast<double>(block.count) * std::log(typical_.back() / unit);
  }
  priors_.set_outside(
      std::exp(log_typical / static_cast<double>(std::max<std::size_t>(1, measurements.size()))));
  for (const Block& block : measurements.blocks())
    blocks_.emplace_back(measurements, block, states, priors_, shape_,
                         nominal_residual.segment(block.first, block.count),
                         root_mean_square(nominal_residual, block.first, block.count, shape_));
  if (shape_.periodic.cols() > 0) periodic_.compute(weights(shape_).asDiagonal() * shape_.periodic);
}

std::unique_ptr<Likelihood> Likelihood::of_noise_alone() const {
  return std::make_unique<Likelihood>(measurements_, states_, noise_alone(), shape_, nominal_residual_);
}

VectorXd Likelihood::periodic_part(const VectorXd& values) const {
  if (shape_.periodic.cols() == 0) return VectorXd::Zero(values.size());
  return shape_.periodic * periodic_.solve(weights(shape_).cwiseProduct(values));
}

std::vector<BlockLikelihood::Look> Likelihood::look_at_blocks(const VectorXd& residual,
                                                              const MatrixXd& jacobian) const {
  std::vector<BlockLikelihood::Look> looks;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = measurements_.blocks()[b];
    MatrixXd columns(block.count, 1 + jacobian.cols());
    columns.col(0) = residual.segment(block.first, block.count);
    columns.rightCols(jacobian.cols()) = jacobian.middleRows(block.first, block.count);
    looks.push_back(blocks_[b].look(columns));
  }
  return looks;
}

std::vector<double> Likelihood::together(const std::vector<BlockLikelihood::Look>& blocks) const {
  std::vector<double> all(priors_.amplitude.size(), 0.0);
  for (const BlockLikelihood::Look& one : blocks) all = sum(all, one.log_by_amplitude);
  return all;
}

/// Readings that are marked stand apart from their block: each has a density of its own about the discrepancy
/// that the others show, at the most probable scale. A model that explains a marked reading makes it one like
/// others.
void Likelihood::add_marked(const std::vector<BlockLikelihood::Split>& at, const VectorXd& residual,
                            const MatrixXd& jacobian, Look& look) const {
  VectorXd left = residual, sigma = shape_.relative;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = measurements_.blocks()[b];
    left.segment(block.first, block.count) -= at[b].delta;
    sigma.segment(block.first, block.count) *= at[b].scale;
  }
  left -= periodic_part(left);
  const OutlierModel outliers = shape_.outliers();
  double sum = 0;
  for (Eigen::Index row = 0; row < left.size(); ++row) {
    if (!shape_.outlier[static_cast<std::size_t>(row)]) {
      sum += std::log(1 - outliers.share);
      continue;
    }
    const double z = left(row) / sigma(row);
    const double density = outliers.log_density(z);
    sum += density - std::log(sigma(row) * measurements_.sigma()(row));
    if (jacobian.cols() == 0) continue;
    const double inlier = std::exp(outliers.log_inlier(z) - density);
    const double curvature =
        inlier + (1 - inlier) * 2 / (priors::outlier_width * priors::outlier_width + z * z);
    const VectorXd slope = jacobian.row(row).transpose() / sigma(row);
    look.gradient -= curvature * z * slope;
    look.information += curvature * slope * slope.transpose();
  }
  look.log_likelihood += sum;
  for (double& one : look.log_by_amplitude) one += sum;
}

Look Likelihood::look(const VectorXd& residual, const MatrixXd& jacobian) const {
  const std::vector<BlockLikelihood::Look> blocks = look_at_blocks(residual, jacobian);
  Look result;
  result.log_by_amplitude = together(blocks);
  result.log_likelihood = log_sum(sum(result.log_by_amplitude, priors_.log_amplitude));
  result.discrepancy.assign(priors_.amplitude.size(), 0.0);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    result.channels.push_back({blocks[b].log_by_amplitude, blocks[b].log_by_scale, blocks[b].discrepancy});
    const double share =
        static_cast<double>(measurements_.blocks()[b].count) / static_cast<double>(measurements_.size());
    for (std::size_t a = 0; a < result.discrepancy.size(); ++a)
      result.discrepancy[a] += share * blocks[b].discrepancy[a];
  }
  const std::vector<double> posterior = log_posterior(result.log_by_amplitude, priors_.log_amplitude);
  result.gradient = VectorXd::Zero(jacobian.cols());
  result.information = MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  std::vector<BlockLikelihood::Split> most_probable;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (jacobian.cols() > 0) blocks_[b].add_slopes(blocks[b], posterior, result.gradient, result.information);
    most_probable.push_back(blocks_[b].most_probable(blocks[b], posterior));
  }
  add_marked(most_probable, residual, jacobian, result);
  return result;
}

Decomposition Likelihood::decompose(const VectorXd& residual) const {
  const std::vector<BlockLikelihood::Look> blocks = look_at_blocks(residual, MatrixXd(residual.size(), 0));
  const std::vector<double> posterior = log_posterior(together(blocks), priors_.log_amplitude);
  Decomposition result{VectorXd(residual.size()), {}, {{}, shape_}};
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = measurements_.blocks()[b];
    const BlockLikelihood::Split split = blocks_[b].split(blocks[b], posterior);
    result.delta.segment(block.first, block.count) = split.delta;
    result.noise.channels.push_back({block.channel, split.scale, split.correlation, split.length});
  }
  result.periodic = periodic_part(residual - result.delta);
  return result;
}

void Likelihood::prune(const VectorXd& residual) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = measurements_.blocks()[b];
    blocks_[b].prune(residual.segment(block.first, block.count));
  }
}

}  // namespace plumbline::diagnose
