#include "diagnose/motion/likelihood.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <plumbline/base/parallel.hpp>

#include "diagnose/log_sum.hpp"

namespace plumbline::motion {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Degrees of freedom of a segment's scale, whose logarithm is thus known to about a ninth. Fewer let a fit
/// give up the segments that it does not reach.
constexpr double freedom = 40;
/// Times of correlation, s; equally probable. The longest is a quarter of a segment: what varies more slowly
/// is an offset of the segment, which belongs to the zero of the joint.
constexpr std::array correlations{0.06, 0.17, 0.5};

}  // namespace

/// Of one segment: columns whose readings are made independent and of variance one, one after the other, by
/// Kalman's filter of a discrepancy that forgets exponentially. The initial state is summed out beside them.
struct Likelihood::Whitened {
  VectorXd residual;
  MatrixXd slopes, initial;
  double log_det = 0;      ///< of the covariance of all that is not the initial state
  Eigen::Matrix2d begin;   ///< precision of the begin
  Eigen::Vector2d pulled;  ///< of its most probable value, times the precision
  Eigen::LDLT<Eigen::Matrix2d> by_begin;

  /// \param kept      share of the discrepancy that each reading has from the one before; 0 of the first
  /// \param variance  of the discrepancy, by reading
  Whitened(const SegmentMeans& left, const VectorXd& kept, const VectorXd& variance, bool with_slopes)
      : residual(left.residual + left.initial * left.begin), initial(left.initial) {
    if (with_slopes) slopes = left.slopes;
    const Index n = residual.size(), p = slopes.cols();
    Eigen::RowVectorXd expected = Eigen::RowVectorXd::Zero(3 + p), own(3 + p);
    double unsure = 0;
    for (Index i = 0; i < n; ++i) {
      expected *= kept(i);
      unsure = kept(i) * kept(i) * unsure + (1 - kept(i) * kept(i)) * variance(i);
      const double all = unsure + left.variance(i), share = unsure / all, scale = 1 / std::sqrt(all);
      own(0) = residual(i), own.segment<2>(1) = initial.row(i);
      if (p > 0) own.tail(p) = slopes.row(i);
      own -= expected;
      expected += share * own;
      unsure *= 1 - share;
      log_det += std::log(all);
      residual(i) = scale * own(0), initial.row(i) = scale * own.segment<2>(1);
      if (p > 0) slopes.row(i) = scale * own.tail(p);
    }
    begin = Eigen::Matrix2d::Identity() + initial.transpose() * initial;
    pulled = initial.transpose() * residual;
    by_begin.compute(begin);
  }
  [[nodiscard]] double square() const { return residual.squaredNorm() - pulled.dot(by_begin.solve(pulled)); }
  [[nodiscard]] double log_density() const {
    const auto n = static_cast<double>(residual.size());
    return std::lgamma((freedom + n) / 2) - std::lgamma(freedom / 2) -
           n / 2 * std::log(freedom * std::numbers::pi) - (log_det + std::log(begin.determinant())) / 2 -
           (freedom + n) / 2 * std::log1p(square() / freedom);
  }
};

VectorXd Likelihood::kept(const SegmentMeans& left, double correlation) {
  VectorXd share = VectorXd::Zero(left.time.size());
  for (Index i = 1; i < share.size(); ++i)
    if (left.quantity[static_cast<std::size_t>(i)] == left.quantity[static_cast<std::size_t>(i - 1)])
      share(i) = std::exp(-(left.time(i) - left.time(i - 1)) / correlation);
  return share;
}

VectorXd Likelihood::variance(const SegmentMeans& left, double amplitude) const {
  VectorXd all(left.time.size());
  for (Index i = 0; i < all.size(); ++i) {
    const std::size_t own = left.quantity[static_cast<std::size_t>(i)];
    const double error = numerical_.empty() ? 0 : numerical_[left.log][own];
    all(i) = std::pow(amplitude * units_[own] / unit(), 2) + error * error;
  }
  return all;
}

Slope Likelihood::slope(const std::vector<SegmentMeans>& left, const Cell& cell) const {
  const Index parameters = left.front().slopes.cols();
  Slope sum{0, VectorXd::Zero(parameters), MatrixXd::Zero(parameters, parameters), {}, {}};
  for (const SegmentMeans& one : left) {
    const Whitened white(one, kept(one, cell.correlation), variance(one, cell.amplitude), true);
    const double weight = (freedom + static_cast<double>(one.time.size())) / (freedom + white.square());
    const Begin begin = white.by_begin.solve(white.pulled);
    const MatrixXd across = white.initial.transpose() * white.slopes, moved = white.by_begin.solve(across);
    sum.log_likelihood += white.log_density();
    sum.gradient += weight * (white.slopes.transpose() * white.residual - across.transpose() * begin);
    sum.information += weight * (white.slopes.transpose() * white.slopes - across.transpose() * moved);
    sum.begin.emplace_back(begin);
    sum.begin_slopes.emplace_back(-moved);
  }
  return sum;
}

Look Likelihood::look(const std::vector<SegmentMeans>& left) const {
  const std::size_t sizes = priors_.amplitude.size();
  using ByCell = std::vector<std::array<double, correlations.size()>>;
  std::vector<ByCell> by_segment(left.size(), ByCell(sizes));
  in_parallel(left.size(), available_threads(), [&](std::size_t s) {
    for (std::size_t c = 0; c < correlations.size(); ++c) {
      const VectorXd from_before = kept(left[s], correlations[c]);
      for (std::size_t a = 0; a < sizes; ++a)
        by_segment[s][a][c] =
            Whitened(left[s], from_before, variance(left[s], unit() * priors_.amplitude[a]), false)
                .log_density();
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
