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

Eigen::MatrixXd Likelihood::covariance(const SegmentMeans& left, const Cell& cell) const {
  const Eigen::Index n = left.time.size();
  Eigen::MatrixXd c = left.initial * left.initial.transpose();
  c.diagonal() += left.variance;
  if (cell.amplitude == 0) return c;
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t own = left.quantity[static_cast<std::size_t>(i)];
    const double amplitude = cell.amplitude * units_[own] / unit();
    for (Eigen::Index j = 0; j < n; ++j)
      if (left.quantity[static_cast<std::size_t>(j)] == own)
        c(i, j) +=
            amplitude * amplitude * std::exp(-std::abs(left.time(i) - left.time(j)) / cell.correlation);
  }
  return c;
}

/// Of one segment, whose columns are whitened.
struct Likelihood::Whitened {
  Eigen::VectorXd residual;
  Eigen::MatrixXd slopes, initial;  ///< where they are wanted
  double log_det;
  [[nodiscard]] double square() const { return residual.squaredNorm(); }
  [[nodiscard]] double log_density() const {
    const auto n = static_cast<double>(residual.size());
    return std::lgamma((freedom + n) / 2) - std::lgamma(freedom / 2) -
           n / 2 * std::log(freedom * std::numbers::pi) - log_det / 2 -
           (freedom + n) / 2 * std::log1p(square() / freedom);
  }
};

Likelihood::Whitened Likelihood::whitened(const SegmentMeans& left, const Cell& cell,
                                          bool with_slopes) const {
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance(left, cell));
  Whitened white{left.residual + left.initial * left.begin, {}, {}, 0};
  factor.matrixL().solveInPlace(white.residual);
  white.log_det = 2 * factor.matrixLLT().diagonal().array().log().sum();
  if (!with_slopes) return white;
  white.slopes = factor.matrixL().solve(left.slopes);
  white.initial = factor.matrixL().solve(left.initial);
  return white;
}

Slope Likelihood::slope(const std::vector<SegmentMeans>& left, const Cell& cell) const {
  const Eigen::Index parameters = left.front().slopes.cols();
  Slope sum{0, Eigen::VectorXd::Zero(parameters), Eigen::MatrixXd::Zero(parameters, parameters), {}, {}};
  for (const SegmentMeans& one : left) {
    const Whitened white = whitened(one, cell, true);
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
  std::vector<std::array<double, correlations.size()>> by_cell(sizes);
  in_parallel(sizes, available_threads(), [&](std::size_t a) {
    for (std::size_t c = 0; c < correlations.size(); ++c) {
      by_cell[a][c] = 0;
      const Cell cell{unit() * priors_.amplitude[a], correlations[c]};
      for (const SegmentMeans& one : left) by_cell[a][c] += whitened(one, cell, false).log_density();
    }
  });
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
