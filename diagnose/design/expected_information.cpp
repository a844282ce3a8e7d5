#include "diagnose/design/expected_information.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace plumbline::diagnose {
namespace {

/// A Gaussian prediction with the covariance I + half half^T.
struct Gaussian {
  Eigen::VectorXd mean;
  Eigen::MatrixXd half;
  double log_determinant;
};

/// The factor of I + half^T half, whose determinant is that of I + half half^T: parameters are fewer than
/// readings.
Eigen::LLT<Eigen::MatrixXd> small_factor(const Eigen::MatrixXd& half) {
  const Eigen::Index columns = half.cols();
  return Eigen::LLT<Eigen::MatrixXd>(Eigen::MatrixXd::Identity(columns, columns) + half.transpose() * half);
}

double log_determinant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  return 2 * factor.matrixLLT().diagonal().array().log().sum();
}

Gaussian prediction(const Forecast& hypothesis) {
  // The covariance may be singular to rounding.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spread(hypothesis.covariance);
  Eigen::MatrixXd half =
      hypothesis.slope * spread.eigenvectors() * spread.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  const double determinant = log_determinant(small_factor(half));
  return {hypothesis.read, std::move(half), determinant};
}

/// Bhattacharyya's distance; the inverse by Woodbury's identity.
double distance(const Gaussian& a, const Gaussian& b) {
  Eigen::MatrixXd half(a.half.rows(), a.half.cols() + b.half.cols());
  half << a.half, b.half;
  half /= std::numbers::sqrt2;
  const Eigen::LLT<Eigen::MatrixXd> between = small_factor(half);
  const Eigen::VectorXd difference = a.mean - b.mean, seen = half.transpose() * difference;
  return (difference.squaredNorm() - seen.dot(between.solve(seen))) / 8 +
         (log_determinant(between) - (a.log_determinant + b.log_determinant) / 2) / 2;
}

}  // namespace

double expected_information(const std::vector<Forecast>& hypotheses) {
  std::vector<Gaussian> all;
  for (const Forecast& hypothesis : hypotheses) all.push_back(prediction(hypothesis));
  const std::size_t count = all.size();
  Eigen::MatrixXd overlap =
      Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
      overlap(i, j) = overlap(j, i) = std::exp(-distance(all[a], all[b]));
    }
  return -(overlap.rowwise().mean().array().log().mean());
}

}  // namespace plumbline::diagnose
