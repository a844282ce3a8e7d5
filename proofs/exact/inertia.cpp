#include "proofs/exact/inertia.hpp"

#include <Eigen/Eigenvalues>

namespace plumbline::proofs {

Eigen::MatrixXd middle(const Matrix<Span>& A) {
  return A.unaryExpr([](const Span& x) { return x.middle(); });
}

std::optional<std::size_t> negative_eigenvalues(const Matrix<Span>& K) {
  const Eigen::Index size = K.rows();
  const Eigen::MatrixXd X = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(middle(K)).eigenvectors();
  if (!X.allFinite()) return std::nullopt;
  Matrix<Span> KX = Matrix<Span>::Constant(size, size, Span(0));
  for (Eigen::Index j = 0; j < size; ++j) {
    for (Eigen::Index a = 0; a < size; ++a) {
      for (Eigen::Index b = 0; b < size; ++b) KX(a, j) += X(b, j) * K(a, b);
    }
  }
  std::size_t negative = 0;
  for (Eigen::Index i = 0; i < size; ++i) {
    Span diagonal(0);
    double others = 0;
    for (Eigen::Index j = 0; j < size; ++j) {
      Span sum(0);
      for (Eigen::Index a = 0; a < size; ++a) sum += X(a, i) * KX(a, j);
      if (i == j)
        diagonal = sum;
      else
        others = Span::up(others + sum.magnitude());
    }
    if (diagonal.low > others) continue;
    if (!(diagonal.high < -others)) return std::nullopt;
    ++negative;
  }
  return negative;
}

}  // namespace plumbline::proofs
