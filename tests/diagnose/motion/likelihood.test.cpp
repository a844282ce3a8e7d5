#include "diagnose/motion/likelihood.hpp"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <random>

namespace plumbline::motion {
namespace {

/// Two quantities whose readings are unevenly spaced, with three parameters.
SegmentMeans drawn_segment() {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(0, 1);
  constexpr Eigen::Index each = 15, n = 2 * each;
  SegmentMeans left{0,
                    {},
                    Eigen::VectorXd(n),
                    Eigen::VectorXd(n),
                    Eigen::MatrixXd(n, 3),
                    Eigen::MatrixXd(n, 2),
                    Eigen::VectorXd(n),
                    Begin(0.3, -0.2)};
  for (Eigen::Index i = 0; i < n; ++i) {
    left.quantity.push_back(i < each ? 0 : 2);
    const auto k = static_cast<double>(i % each);
    left.time(i) = 0.05 * k + 0.002 * k * k;
    left.residual(i) = normal(generator), left.variance(i) = 0.2 + 0.01 * k;
    for (Eigen::Index c = 0; c < 3; ++c) left.slopes(i, c) = normal(generator);
    left.initial.row(i) << 1 - 0.01 * k, 0.05 * k;
  }
  return left;
}

}  // namespace

TEST_CASE("readings that are whitened one by one have the likelihood of their whole covariance") {
  const SegmentMeans left = drawn_segment();
  const Quantities units{0.5, 1, 0.8, 1}, errors{0.1, 0, 0.3, 0};
  const Likelihood likelihood(units, 1, {errors});
  const Cell cell{0.7, 0.17};
  const Eigen::Index n = left.time.size();
  Eigen::MatrixXd covariance = left.initial * left.initial.transpose();
  covariance.diagonal() += left.variance;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::size_t own = left.quantity[static_cast<std::size_t>(i)];
      if (left.quantity[static_cast<std::size_t>(j)] != own) continue;
      const double size = cell.amplitude * units[own] / units[0];
      covariance(i, j) += (size * size + errors[own] * errors[own]) *
                          std::exp(-std::abs(left.time(i) - left.time(j)) / cell.correlation);
    }
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  const Eigen::VectorXd residual = left.residual + left.initial * left.begin, solved = factor.solve(residual);
  const double square = residual.dot(solved), readings = static_cast<double>(n),
               log_det = 2 * factor.matrixLLT().diagonal().array().log().sum();
  constexpr double freedom = 40;  // of a segment's scale (likelihood.cpp)
  const double log_density = std::lgamma((freedom + readings) / 2) - std::lgamma(freedom / 2) -
                             readings / 2 * std::log(freedom * std::numbers::pi) - log_det / 2 -
                             (freedom + readings) / 2 * std::log1p(square / freedom);
  const double weight = (freedom + readings) / (freedom + square);
  const Slope slope = likelihood.slope({left}, cell);
  // Sums of thirty products, of numbers near one.
  CHECK(slope.log_likelihood == doctest::Approx(log_density).epsilon(1e-12));
  CHECK((slope.gradient - weight * left.slopes.transpose() * solved).norm() < 1e-11);
  CHECK((slope.information - weight * left.slopes.transpose() * factor.solve(left.slopes)).norm() < 1e-10);
  CHECK((slope.begin.front() - left.initial.transpose() * solved).norm() < 1e-11);
  CHECK((slope.begin_slopes.front() + left.initial.transpose() * factor.solve(left.slopes)).norm() < 1e-11);
}

}  // namespace plumbline::motion
