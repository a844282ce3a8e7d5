#pragma once
/// \file
/// The straight chain to leading order in small joint angles, paper equations (25) to (33).
///
/// The paper counts compression as positive F_x here: (29) reads K q + S1 q F_x + S0 F_y = 0.
///
/// \code{.cpp}
/// // The critical force of two links on a passive base, 2 k / L, is a root of (33), in fractions.
/// const Chain<Rational> chain({1, 1}, {0, 1});
/// const Matrix<Rational> M = matrix_A(chain) * Rational(2) + matrix_B(chain);
/// Eigen::FullPivLU<Matrix<Rational>> lu(M);
/// assert(lu.rank() == 2);  // of 3
/// \endcode

#include <plumbline/chain/chain.hpp>
#include <plumbline/chain/kinematics.hpp>

namespace plumbline {

/// Shortening and lateral deflection (25) of the end point, each to its leading order:
/// x is sum L_j theta_j^2 / 2, y is sum L_j theta_j.
template <Number Real>
Point<Real> small_deflection(const Chain<Real>& chain, const std::vector<Real>& q) {
  Point<Real> delta{Real(0), Real(0)};
  const std::vector<Real> theta = orientations(q);
  for (std::size_t j = 0; j < chain.size(); ++j) {
    delta.x = delta.x + chain.length()[j] * (theta[j] * theta[j]) / Real(2);
    delta.y = delta.y + chain.length()[j] * theta[j];
  }
  return delta;
}

/// S0 of (28), n x 1: entry i is z_i = L_i + … + L_n.
template <Number Real>
Vector<Real> matrix_S0(const Chain<Real>& chain) {
  const std::vector<Real> z = distance_to_end(chain);
  return Eigen::Map<const Vector<Real>>(z.data(), static_cast<Eigen::Index>(z.size()));
}

/// S1 of (28), n x n: entry (i, j) is -z_max(i, j).
template <Number Real>
Matrix<Real> matrix_S1(const Chain<Real>& chain) {
  const Vector<Real> z = matrix_S0(chain);
  Matrix<Real> S1(z.size(), z.size());
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    for (Eigen::Index j = 0; j < z.size(); ++j) S1(i, j) = -z(std::max(i, j));
  }
  return S1;
}

/// Jacobian (26) to leading order, as (27) writes it: the transpose of [S1 q | S0].
template <Number Real>
Matrix<Real> small_jacobian(const Chain<Real>& chain, const Vector<Real>& q) {
  Matrix<Real> transposed(q.size(), 2);
  transposed << matrix_S1(chain) * q, matrix_S0(chain);
  return transposed.transpose();
}

/// A of (33), (n+1) x (n+1): S1, bordered by zeros.
template <Number Real>
Matrix<Real> matrix_A(const Chain<Real>& chain) {
  const auto n = static_cast<Eigen::Index>(chain.size());
  Matrix<Real> A = Matrix<Real>::Constant(n + 1, n + 1, Real(0));
  A.topLeftCorner(n, n) = matrix_S1(chain);
  return A;
}

/// B of (33), (n+1) x (n+1): the joint stiffness matrix K_q, bordered by S0.
template <Number Real>
Matrix<Real> matrix_B(const Chain<Real>& chain) {
  const auto n = static_cast<Eigen::Index>(chain.size());
  Matrix<Real> B = Matrix<Real>::Constant(n + 1, n + 1, Real(0));
  for (Eigen::Index i = 0; i < n; ++i) B(i, i) = chain.stiffness()[static_cast<std::size_t>(i)];
  B.topRightCorner(n, 1) = matrix_S0(chain);
  B.bottomLeftCorner(1, n) = matrix_S0(chain).transpose();
  return B;
}

}  // namespace plumbline
