#include "diagnose/inference/likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

using priors::outlier_share, priors::outlier_width;

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

VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// By value of a block, one past the last value of its run; of the block where all runs are one session.
std::vector<Eigen::Index> ends_of_runs(const Measurements& measurements, const Block& block,
                                       bool one_session) {
  const auto run_of = [&](Eigen::Index value) {
    return measurements.places()[static_cast<std::size_t>(block.first + value)].run;
  };
  std::vector<Eigen::Index> end(static_cast<std::size_t>(block.count), block.count);
  for (Eigen::Index value = block.count - 2; value >= 0 && !one_session; --value)
    end[static_cast<std::size_t>(value)] =
        run_of(value) == run_of(value + 1) ? end[static_cast<std::size_t>(value + 1)] : value + 1;
  return end;
}

}  // namespace

double log_outlier(double distance) {
  return std::log(outlier_share / (outlier_width * std::numbers::pi)) -
         std::log1p(std::pow(distance / outlier_width, 2));
}

double log_inlier(double distance) {
  return std::log((1 - outlier_share) / std::sqrt(2 * std::numbers::pi)) - distance * distance / 2;
}

std::vector<double> log_posterior(const std::vector<double>& log_likelihood,
                                  const std::vector<double>& log_prior) {
  std::vector<double> joint(log_likelihood.size());
  for (std::size_t a = 0; a < joint.size(); ++a) joint[a] = log_likelihood[a] + log_prior[a];
  const double all = log_sum(as_vector(joint));
  for (double& one : joint) one -= all;
  return joint;
}

Likelihood::Likelihood(const Measurements& measurements, const CommandStates& states,
                       const Hyperpriors& priors, NoiseShape shape, const VectorXd& nominal_residual)
    : measurements_(measurements),
      states_(states),
      priors_(priors),
      shape_(std::move(shape)),
      nominal_size_(root_mean_square(nominal_residual, 0, nominal_residual.size(), shape_)) {
  for (const Block& block : measurements.blocks())
    blocks_.emplace_back(measurements, block, states, priors_, shape_,
                         root_mean_square(nominal_residual, block.first, block.count, shape_));
  if (shape_.periodic.cols() > 0) periodic_.compute(weights(shape_).asDiagonal() * shape_.periodic);
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
  std::vector<double> sum(priors_.amplitude.size(), 0.0);
  for (const BlockLikelihood::Look& one : blocks)
    for (std::size_t a = 0; a < sum.size(); ++a) sum[a] += one.log_by_amplitude[a];
  return sum;
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
  double sum = 0;
  for (Eigen::Index row = 0; row < left.size(); ++row) {
    if (!shape_.outlier[static_cast<std::size_t>(row)]) {
      sum += std::log(1 - outlier_share);
      continue;
    }
    const double z = left(row) / sigma(row);
    const double density = log_sum(Eigen::Vector2d(log_outlier(z), log_inlier(z)));
    sum += density - std::log(sigma(row) * measurements_.sigma()(row));
    if (jacobian.cols() == 0) continue;
    const double inlier = std::exp(log_inlier(z) - density);
    const double curvature = inlier + (1 - inlier) * 2 / (outlier_width * outlier_width + z * z);
    const VectorXd slope = jacobian.row(row).transpose() / sigma(row);
    look.gradient -= curvature * z * slope;
    look.information += curvature * slope * slope.transpose();
  }
  look.log_likelihood += sum;
  for (double& one : look.log_by_amplitude) one += sum;
  look.log_nugget += sum;
  look.log_one_channel += sum;
}

double Likelihood::log_outside(const std::vector<double>& by_amplitude) const {
  return log_sum(as_vector(by_amplitude) + as_vector(priors_.log_amplitude_outside));
}

Look Likelihood::look(const VectorXd& residual, const MatrixXd& jacobian) const {
  const std::vector<BlockLikelihood::Look> blocks = look_at_blocks(residual, jacobian);
  Look result;
  result.log_by_amplitude = together(blocks);
  std::vector<double> nugget;
  for (const BlockLikelihood::Look& one : blocks) nugget.push_back(one.log_nugget);
  const double any = log_sum(as_vector(nugget));
  result.log_nugget = result.log_by_amplitude.front() + any - std::log(static_cast<double>(nugget.size()));
  for (const BlockLikelihood::Look& one : blocks)
    result.nugget_size += std::exp(one.log_nugget - any) * one.nugget_size / nominal_size_;
  std::vector<double> alone;
  for (const BlockLikelihood::Look& one : blocks)
    alone.push_back(log_outside(one.log_by_amplitude) - one.log_by_amplitude.front());
  result.log_one_channel = result.log_by_amplitude.front() + log_sum(as_vector(alone)) -
                           std::log(static_cast<double>(alone.size()));
  std::vector<double> joint(result.log_by_amplitude.size());
  for (std::size_t a = 0; a < joint.size(); ++a)
    joint[a] = result.log_by_amplitude[a] + priors_.log_amplitude[a];
  result.log_likelihood = log_sum(as_vector(joint));
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

double Likelihood::log_step(const VectorXd& residual) const {
  const auto place_of = [&](Eigen::Index row) {
    const ReadingPlace& at = measurements_.places()[static_cast<std::size_t>(row)];
    return std::pair(at.run, at.reading);
  };
  std::map<std::pair<std::size_t, std::size_t>, double> factor;  // by run and reading, of a step there
  for (Eigen::Index row = 0; row < residual.size(); ++row) factor.emplace(place_of(row), 0.0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = measurements_.blocks()[b];
    const VectorXd own = blocks_[b].log_steps(residual.segment(block.first, block.count),
                                              ends_of_runs(measurements_, block, states_.one_session));
    Eigen::Index value = 0;
    for (auto& [place, sum] : factor) {
      while (value < block.count && place_of(block.first + value) < place) ++value;
      const bool reaches =
          value < block.count && (states_.one_session || place_of(block.first + value).first == place.first);
      sum += log_sum(Eigen::Vector2d(reaches ? own(value) : 0, 0)) - std::log(2.0);
    }
  }
  std::vector<double> steps;
  for (auto step = std::next(factor.begin()); step != factor.end(); ++step)
    if (states_.one_session || std::prev(step)->first.first == step->first.first)
      steps.push_back(step->second);
  if (steps.empty()) return -std::numeric_limits<double>::infinity();
  return look(residual).log_by_amplitude.front() + log_sum(as_vector(steps)) -
         std::log(static_cast<double>(steps.size()));
}

void Likelihood::prune(const VectorXd& residual) {
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = measurements_.blocks()[b];
    blocks_[b].prune(residual.segment(block.first, block.count));
  }
}

}  // namespace plumbline::diagnose
