#pragma once
/// \file
/// Linear least squares: one file has the decomposition, which takes a compiler seconds wherever it is made.

#include <Eigen/Core>
#include <Eigen/QR>

namespace plumbline::diagnose {

/// The columns of a matrix as a basis, by Householder's reflections with pivoting.
class LeastSquares {
 public:
  /// \param columns  any shape, also without columns
  explicit LeastSquares(const Eigen::MatrixXd& columns);

  /// As many columns as are independent in double precision.
  [[nodiscard]] Eigen::Index rank() const;
  /// Coefficients that leave least of these values, one a row; a column that depends on others has none.
  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& values) const;
  /// Orthonormal columns, as many as there were, that begin with a basis of theirs.
  [[nodiscard]] Eigen::MatrixXd orthonormal() const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors_;
};

/// Rows as many as columns, or as there were if these are fewer, with the same lengths and angles between
/// columns.
Eigen::MatrixXd triangular_factor(const Eigen::MatrixXd& columns);

}  // namespace plumbline::diagnose
