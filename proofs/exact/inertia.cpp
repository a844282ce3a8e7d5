#include "proofs/exact/inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace plumbline::proofs {

Eigen::MatrixXd middle(const Matrix<Span>& A) {
  return A.unaryExpr([](const Span& x) { return x.middle(); });
}

namespace {

/// D K D with powers of two in D that bring all rows to one size: it has as many negative eigenvalues
/// (Sylvester), and rounding does not drown rows of small units, such as that of a constraint beside
/// stiffnesses.
Matrix<Span> balanced(Matrix<Span> K) {
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round)
    for (Eigen::Index i = 0; i < K.rows(); ++i) {
      double largest = 0;
      for (Eigen::Index j = 0; j < K.cols(); ++j) largest = std::max(largest, K(i, j).magnitude());
      if (!(largest > 0) || !std::isfinite(largest)) continue;
      const double scale = std::ldexp(1.0, -std::ilogb(largest) / 2);
      for (Eigen::Index j = 0; j < K.cols(); ++j) K(i, j) = scale * K(i, j), K(j, i) = scale * K(j, i);
    }
  return K;
}

}  // namespace

std::optional<std::size_t> negative_eigenvalues(const Matrix<Span>& stiffness) {
  const Matrix<Span> K = balanced(stiffness);
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
