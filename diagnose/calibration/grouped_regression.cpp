#include "diagnose/calibration/grouped_regression.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "diagnose/inference/hyperpriors.hpp"
#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {
namespace {

/// Half-Cauchy density of a size over the typical one.
double log_density_of_size(double size) {
  return std::log(2 / std::numbers::pi) - std::log1p(size * size);
}

}  // namespace

GroupedRegression::GroupedRegression(const Eigen::MatrixXd& unknown, const Eigen::MatrixXd& columns,
                                     std::vector<ColumnGroup> groups, const Eigen::VectorXd& values)
    : groups_(std::move(groups)) {
  const LeastSquares factors(unknown);
  const Eigen::MatrixXd span = unknown.cols() > 0
                                   ? Eigen::MatrixXd(factors.orthonormal().leftCols(factors.rank()))
                                   : Eigen::MatrixXd(values.size(), 0);
  const Eigen::MatrixXd left = columns - span * (span.transpose() * columns);
  const Eigen::VectorXd rest = values - span * (span.transpose() * values);
  gram_ = left.transpose() * left;
  product_ = left.transpose() * rest;
  squares_ = rest.squaredNorm();
  count_ = static_cast<double>(values.size() - span.cols());
}

std::vector<Eigen::Index> GroupedRegression::columns_of(const std::vector<std::size_t>& groups) const {
  std::vector<Eigen::Index> columns;
  for (const std::size_t g : groups)
    for (Eigen::Index c = 0; c < groups_[g].count; ++c) columns.push_back(groups_[g].first + c);
  return columns;
}

GroupedFit GroupedRegression::fit(const std::vector<std::size_t>& groups) const {
  constexpr int enough = 60;
  return iterated({groups, std::vector<double>(groups.size(), 1), std::sqrt(squares_ / count_), {}, {}, 0},
                  enough);
}

GroupedFit GroupedRegression::tied(const std::vector<std::size_t>& groups, double size) const {
  return iterated({groups, std::vector<double>(groups.size(), size), 1, {}, {}, 0}, 0);
}

GroupedFit GroupedRegression::iterated(GroupedFit fit, int iterations) const {
  constexpr double smallest = 1e-4;  // of the typical size
  const std::vector<Eigen::Index> columns = columns_of(fit.groups);
  const Eigen::MatrixXd gram = gram_(columns, columns);
  const Eigen::VectorXd product = product_(columns);
  Eigen::VectorXd size(gram.rows());
  double variance = std::max(1e-300, fit.noise * fit.noise), log_determinant = 0, left = 0;
  std::vector<double> determined(fit.groups.size(), 0);
  for (int i = 0; i <= iterations; ++i) {
    Eigen::Index next = 0;
    for (std::size_t g = 0; g < fit.groups.size(); ++g) {
      const Eigen::Index count = groups_[fit.groups[g]].count;
      size.segment(next, count).setConstant(fit.size[g]);
      next += count;
    }
    // Coefficients in units of their sizes, which may be small.
    Eigen::MatrixXd precision = size.asDiagonal() * gram * size.asDiagonal() / variance;
    precision.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> factor(precision);
    const Eigen::MatrixXd inverse =
        factor.solve(Eigen::MatrixXd::Identity(precision.rows(), precision.cols()));
    fit.mean = size.cwiseProduct(inverse * size.cwiseProduct(product)) / variance;
    fit.covariance = size.asDiagonal() * inverse * size.asDiagonal();
    log_determinant = 2 * factor.matrixLLT().diagonal().array().log().sum();
    left = squares_ - product.dot(fit.mean);  // of the values, and of the prior
    if (i == iterations) break;
    double all_determined = 0, prior = 0;
    next = 0;
    for (std::size_t g = 0; g < fit.groups.size(); ++g) {
      const Eigen::Index count = groups_[fit.groups[g]].count;
      const double square = fit.mean.segment(next, count).squaredNorm();
      determined[g] =
          std::max(1e-6, static_cast<double>(count) - inverse.diagonal().segment(next, count).sum());
      prior += square / (fit.size[g] * fit.size[g]);
      fit.size[g] = std::max(smallest, std::sqrt(square / determined[g]));
      all_determined += determined[g];
      next += count;
    }
    variance = std::max(1e-300, (left - variance * prior) / std::max(1.0, count_ - all_determined));
  }
  fit.noise = std::sqrt(variance);
  fit.log_evidence =
      -0.5 * (count_ * std::log(2 * std::numbers::pi * variance) + log_determinant + left / variance) +
      log_scale_prior(std::log(fit.noise));
  for (std::size_t g = 0; g < fit.groups.size(); ++g)  // by Laplace's method over the logarithm of the size
    if (fit.size[g] > smallest)
      fit.log_evidence += log_density_of_size(fit.size[g]) + std::log(fit.size[g]) +
                          0.5 * std::log(std::numbers::pi / std::max(1.0, determined[g]));
  return fit;
}

std::vector<std::size_t> GroupedRegression::promising(const GroupedFit& beside,
                                                      const std::vector<std::size_t>& offered) const {
  constexpr std::size_t few = 12;
  const std::vector<Eigen::Index> columns = columns_of(beside.groups);
  const double variance = beside.noise * beside.noise;
  std::vector<std::pair<double, std::size_t>> gains;
  for (const std::size_t one : offered) {
    if (std::find(beside.groups.begin(), beside.groups.end(), one) != beside.groups.end()) continue;
    const std::vector<Eigen::Index> own = columns_of({one});
    const Eigen::MatrixXd across = gram_(own, columns);
    const Eigen::VectorXd score = (product_(own) - across * beside.mean) / variance;
    Eigen::MatrixXd information =
        gram_(own, own) / variance - across * beside.covariance * across.transpose() / (variance * variance);
    information.diagonal().array() += 1;
    gains.emplace_back(score.dot(information.ldlt().solve(score)), one);
  }
  std::sort(gains.begin(), gains.end(), std::greater<>());
  if (gains.size() > few) gains.resize(few);
  std::vector<std::size_t> best;
  for (const auto& [gain, one] : gains) best.push_back(one);
  return best;
}

GroupedFit GroupedRegression::extended(const std::vector<std::size_t>& always,
                                       const std::vector<std::size_t>& offered) const {
  const double log_choices = std::log(static_cast<double>(std::max<std::size_t>(1, offered.size())));
  constexpr std::size_t most = 6;
  constexpr int short_way = 12, whole_way = 40;
  GroupedFit best = fit(always);
  while (best.groups.size() < always.size() + most) {
    GroupedFit next;
    next.log_evidence = best.log_evidence + log_choices;
    for (const std::size_t one : promising(best, offered)) {
      GroupedFit start = best;
      start.groups.push_back(one), start.size.push_back(1);
      if (GroupedFit with = iterated(std::move(start), short_way); with.log_evidence > next.log_evidence)
        next = std::move(with);
    }
    if (next.groups.empty()) break;
    best = iterated(std::move(next), whole_way);
  }
  return best;
}

}  // namespace plumbline::diagnose
