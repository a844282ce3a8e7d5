#include "diagnose/calibration/grouped_regression.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "diagnose/inference/hyperpriors.hpp"
#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {
namespace {

/// Sizes over the typical one; every order of magnitude between is as probable.
constexpr double smallest = 1e-4, largest = 10;

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

void GroupedRegression::take_columns(GroupedFit& fit) const {
  std::map<Eigen::Index, std::size_t> owner;
  for (std::size_t g = 0; g < fit.groups.size(); ++g) {
    const ColumnGroup& group = groups_[fit.groups[g]];
    for (Eigen::Index c = 0; c < group.count; ++c) owner[group.first + c] = g;
  }
  fit.columns.clear(), fit.owner.clear();
  for (const auto& [column, g] : owner) fit.columns.push_back(column), fit.owner.push_back(g);
}

GroupedFit GroupedRegression::fit(const std::vector<std::size_t>& groups) const {
  constexpr int enough = 60;
  GroupedFit start;
  start.groups = groups, start.size.assign(groups.size(), 1), start.noise = std::sqrt(squares_ / count_);
  return iterated(std::move(start), enough);
}

GroupedFit GroupedRegression::tied(const std::vector<std::size_t>& groups, double size) const {
  GroupedFit start;
  start.groups = groups, start.size.assign(groups.size(), size);
  return iterated(std::move(start), 0);
}

GroupedFit GroupedRegression::iterated(GroupedFit fit, int iterations) const {
  take_columns(fit);
  const Eigen::MatrixXd gram = gram_(fit.columns, fit.columns);
  const Eigen::VectorXd product = product_(fit.columns);
  const auto columns = gram.rows();
  Eigen::VectorXd size(columns), mean;
  Eigen::MatrixXd whitened;  // coefficients over their sizes: L^-1 of their precision L L'
  double variance = std::max(1e-300, fit.noise * fit.noise), log_determinant = 0, left = 0;
  fit.determined.assign(fit.groups.size(), 0);
  for (int i = 0; i <= iterations; ++i) {
    for (Eigen::Index c = 0; c < columns; ++c) size(c) = fit.size[fit.owner[static_cast<std::size_t>(c)]];
    // Coefficients in units of their sizes, which may be small.
    Eigen::MatrixXd precision = size.asDiagonal() * gram * size.asDiagonal() / variance;
    precision.diagonal().array() += 1;
    const Eigen::LLT<Eigen::MatrixXd> factor(precision);
    whitened = factor.matrixL().solve(Eigen::MatrixXd::Identity(columns, columns));
    const Eigen::VectorXd spread = whitened.colwise().squaredNorm().transpose();
    mean = size.cwiseProduct(factor.solve(size.cwiseProduct(product))) / variance;
    log_determinant = 2 * factor.matrixLLT().diagonal().array().log().sum();
    left = squares_ - product.dot(mean);  // of the values, and of the prior
    std::vector<double> square(fit.groups.size(), 0);
    fit.determined.assign(fit.groups.size(), 0);
    for (Eigen::Index c = 0; c < columns; ++c) {
      const std::size_t g = fit.owner[static_cast<std::size_t>(c)];
      square[g] += mean(c) * mean(c), fit.determined[g] += 1 - spread(c);
    }
    if (i == iterations) break;
    double all_determined = 0, prior = 0;
    for (std::size_t g = 0; g < fit.groups.size(); ++g) {
      const double determined = std::max(1e-6, fit.determined[g]);
      prior += square[g] / (fit.size[g] * fit.size[g]);
      fit.size[g] = std::clamp(std::sqrt(square[g] / determined), smallest, largest);
      all_determined += determined;
    }
    variance = std::max(1e-300, (left - variance * prior) / std::max(1.0, count_ - all_determined));
  }
  fit.covariance = size.asDiagonal() * (whitened.transpose() * whitened) * size.asDiagonal();
  fit.mean = Eigen::VectorXd::Zero(gram_.rows());
  fit.mean(fit.columns) = mean;
  fit.noise = std::sqrt(variance);
  fit.log_evidence =
      -0.5 * (count_ * std::log(2 * std::numbers::pi * variance) + log_determinant + left / variance) +
      log_scale_prior(std::log(fit.noise));
  for (std::size_t g = 0; g < fit.groups.size(); ++g)  // by Laplace's method over the logarithm of the size
    if (fit.size[g] > smallest)
      fit.log_evidence += 0.5 * std::log(std::numbers::pi / std::max(1.0, fit.determined[g])) -
                          std::log(std::log(largest / smallest));
  return fit;
}

std::vector<std::size_t> GroupedRegression::promising(const GroupedFit& beside,
                                                      const std::vector<std::size_t>& offered) const {
  constexpr std::size_t few = 16;
  const double variance = beside.noise * beside.noise;
  const Eigen::VectorXd mean = beside.mean(beside.columns);
  std::vector<std::pair<double, std::size_t>> gains;
  // What a group explains already has no score left: of each its farthest member is tried.
  std::map<std::size_t, std::pair<double, std::size_t>> farthest;
  for (const std::size_t one : offered) {
    if (std::find(beside.groups.begin(), beside.groups.end(), one) != beside.groups.end()) continue;
    const auto own = Eigen::seqN(groups_[one].first, groups_[one].count);
    const auto member = std::find(beside.columns.begin(), beside.columns.end(), groups_[one].first);
    if (member != beside.columns.end()) {
      const std::size_t group = beside.owner[static_cast<std::size_t>(member - beside.columns.begin())];
      const std::pair far(beside.mean(own).norm(), one);
      if (const auto [known, first] = farthest.emplace(group, far); !first)
        known->second = std::max(known->second, far);
      continue;
    }
    const Eigen::MatrixXd across = gram_(own, beside.columns);
    const Eigen::VectorXd score = (product_(own) - across * mean) / variance;
    Eigen::MatrixXd information =
        gram_(own, own) / variance - across * beside.covariance * across.transpose() / (variance * variance);
    information.diagonal().array() += 1;
    gains.emplace_back(score.dot(information.ldlt().solve(score)), one);
  }
  std::sort(gains.begin(), gains.end(), std::greater<>());
  if (gains.size() > few) gains.resize(few);
  std::vector<std::size_t> best;
  for (const auto& [gain, one] : gains) best.push_back(one);
  for (const auto& [group, member] : farthest) best.push_back(member.second);
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
