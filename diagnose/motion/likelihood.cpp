#include "diagnose/motion/likelihood.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <plumbline/base/parallel.hpp>

#include "diagnose/log_sum.hpp"

namespace plumbline::motion {
namespace {

/// Degrees of freedom of a segment's scale, whose logarithm is thus known to about a ninth. Fewer let a fit
/// give up the segments that it does not reach.
constexpr double freedom = 40;
/// Times of correlation, s; equally probable. The longest is a quarter of a segment: what varies more slowly
/// is an offset of the segment, which belongs to the zero of the joint.
constexpr std::array correlations{0.06, 0.17, 0.5};

}  // namespace

/// Covariances of a segment at one time of correlation.
struct Likelihood::Correlated {
  Eigen::MatrixXd known;        ///< of the initial state, the noise and the numerical error
  Eigen::MatrixXd discrepancy;  ///< of one of size one
  [[nodiscard]] Eigen::MatrixXd covariance(double amplitude) const {
    return known + amplitude * amplitude * discrepancy;
  }
};

Likelihood::Correlated Likelihood::correlated(const SegmentMeans& left, double correlation) const {
  const Eigen::Index n = left.time.size();
  Correlated all{left.initial * left.initial.transpose(), Eigen::MatrixXd::Zero(n, n)};
  all.known.diagonal() += left.variance;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t own = left.quantity[static_cast<std::size_t>(i)];
    const double size = units_[own] / unit(), error = numerical_.empty() ? 0 : numerical_[left.log][own];
    for (Eigen::Index j = 0; j < n; ++j) {
      if (left.quantity[static_cast<std::size_t>(j)] != own) continue;
      const double alike = std::exp(-std::abs(left.time(i) - left.time(j)) / correlation);
      all.discrepancy(i, j) = size * size * alike;
      all.known(i, j) += error * error * alike;
    }
  }
  return all;
}

/// Of one segment, whose columns are whitened.
struct Likelihood::Whitened {
  Eigen::VectorXd residual;
  Eigen::MatrixXd slopes, initial;  ///< where they are wanted
  double log_det;

  Whitened(const SegmentMeans& left, const Eigen::MatrixXd& covariance, bool with_slopes)
      : residual(left.residual + left.initial * left.begin) {
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    factor.matrixL().solveInPlace(residual);
    log_det = 2 * factor.matrixLLT().diagonal().array().log().sum();
    if (!with_slopes) return;
    slopes = factor.matrixL().solve(left.slopes);
    initial = factor.matrixL().solve(left.initial);
  }
  [[nodiscard]] double square() const { return residual.squaredNorm(); }
  [[nodiscard]] double log_density() const {
    const auto n = static_cast<double>(residual.size());
    return std::lgamma((freedom + n) / 2) - std::lgamma(freedom / 2) -
           n / 2 * std::log(freedom * std::numbers::pi) - log_det / 2 -
           (freedom + n) / 2 * std::log1p(square() / freedom);
  }
};

Slope Likelihood::slope(const std::vector<SegmentMeans>& left, const Cell& cell) const {
  const Eigen::Index parameters = left.front().slopes.cols();
  Slope sum{0, Eigen::VectorXd::Zero(parameters), Eigen::MatrixXd::Zero(parameters, parameters), {}, {}};
  for (const SegmentMeans& one : left) {
    const Whitened white(one, correlated(one, cell.correlation).covariance(cell.amplitude), true);
    const double weight = (freedom + static_cast<double>(one.time.size())) / (freedom + white.square());
    sum.log_likelihood += white.log_density();
    sum.gradient += weight * white.slopes.transpose() * white.residual;
    sum.information += weight * white.slopes.transpose() * white.slopes;
    sum.begin.emplace_back(white.initial.transpose() * white.residual);
    sum.begin_slopes.emplace_back(-white.initial.transpose() * white.slopes);
  }
  return sum;
}

Look Likelihood::look(const std::vector<SegmentMeans>& left) const {
  const std::size_t sizes = priors_.amplitude.size();
  using ByCell = std::vector<std::array<double, correlations.size()>>;
  std::vector<ByCell> by_segment(left.size(), ByCell(sizes));
  in_parallel(left.size(), available_threads(), [&](std::size_t s) {
    for (std::size_t c = 0; c < correlations.size(); ++c) {
      const Correlated all = correlated(left[s], correlations[c]);
      for (std::size_t a = 0; a < sizes; ++a)
        by_segment[s][a][c] =
            Whitened(left[s], all.covariance(unit() * priors_.amplitude[a]), false).log_density();
    }
  });
  ByCell by_cell(sizes, {0, 0, 0});
  for (const ByCell& one : by_segment)
    for (std::size_t a = 0; a < sizes; ++a)
      for (std::size_t c = 0; c < correlations.size(); ++c) by_cell[a][c] += one[a][c];
  Look look{{}, {0, correlations[0]}, 0};
  double best = -std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < sizes; ++a) {
    look.log_by_amplitude.push_back(
        diagnose::log_sum(std::vector<double>(by_cell[a].begin(), by_cell[a].end())) -
        std::log(static_cast<double>(correlations.size())));
    for (std::size_t c = 0; c < correlations.size(); ++c)
      if (const double here = by_cell[a][c] + priors_.log_amplitude[a]; here > best)
        best = here, look.best = {unit() * priors_.amplitude[a], correlations[c]};
  }
  look.log_likelihood = diagnose::log_sum(diagnose::sum(look.log_by_amplitude, priors_.log_amplitude));
  return look;
}

}  // namespace plumbline::motion
