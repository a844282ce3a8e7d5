#include "diagnose/inference/least_squares.hpp"

#include <algorithm>

namespace plumbline::diagnose {

LeastSquares::LeastSquares(const Eigen::MatrixXd& columns) {
  if (columns.cols() > 0) factors_.compute(columns);
}

Eigen::Index LeastSquares::rank() const {
  return factors_.cols() > 0 ? factors_.rank() : 0;
}

Eigen::VectorXd LeastSquares::solve(const Eigen::VectorXd& values) const {
  if (factors_.cols() == 0) return {};
  if (factors_.rank() == 0) return Eigen::VectorXd::Zero(factors_.cols());  // of nothing Eigen divides by it
  return factors_.solve(values);
}

Eigen::MatrixXd LeastSquares::orthonormal() const {
  if (factors_.cols() == 0) return {};
  return factors_.householderQ() * Eigen::MatrixXd::Identity(factors_.rows(), factors_.cols());
}

Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& columns) {
  const Eigen::Index kept = std::min(columns.rows(), columns.cols());
  return Eigen::HouseholderQR<Eigen::MatrixXd>(columns)
      .matrixQR()
      .topRows(kept)
      .triangularView<Eigen::Upper>();
}

}  // namespace plumbline::diagnose
