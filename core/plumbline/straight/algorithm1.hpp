#pragma once
/// \file
/// Algorithm 1 of the paper, as it is written there: the eigenvalues of B^-1 A.
///
/// It is the claim under test and the peer of critical_force.hpp, not the way to compute: B^-1 A is not
/// symmetric and has a defective double zero, so that a floating-point solver loses digits, and it costs
/// O(n^3).
///
/// \code{.cpp}
/// const Chain<double> chain({1, 1, 1, 1}, {1, 1, 1, 1});
/// const double force = algorithm1(chain).front().force;
/// assert(std::abs(force - 0.924027591295903) < 1e-7);  // the double zero costs half of the digits
/// \endcode

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <numeric>
#include <plumbline/chain/mode.hpp>

namespace plumbline {

/// The matrix B^-1 A of (34).
/// \throws Error for n = 1 or a mechanism
template <Ordered Real>
Matrix<Real> algorithm1_matrix(const Chain<Real>& chain) {
  mode_count(chain);
  return matrix_B(chain).partialPivLu().solve(matrix_A(chain));
}

namespace detail {

/// The eigenvector that a solver returned, normalised to norm 1 and q_1 > 0.
///
/// Eigen's back substitution goes wrong where rounding leaves the double zero as a 2 x 2 block whose
/// eigenvalues come out exactly equal (one chain in some thousands): the residual is then far beyond
/// rounding, and two steps of inverse iteration repair the vector.
template <Floating Real>
Vector<Real> checked_eigenvector(const Matrix<Real>& C, const Real& lambda, Vector<Real> v) {
  using std::sqrt;
  const auto size = static_cast<double>(C.rows());
  if (!((C * v - lambda * v).norm() <= Real(10 * size) * epsilon<Real>() * C.norm() * v.norm())) {
    const Real shifted = lambda * (Real(1) + sqrt(epsilon<Real>()));
    const Eigen::PartialPivLU<Matrix<Real>> lu(C - shifted * Matrix<Real>::Identity(C.rows(), C.cols()));
    for (int step = 0; step < 2; ++step) v = lu.solve(v).normalized();
  }
  return v / (v(0) < Real(0) ? Real(-v.norm()) : v.norm());
}

}  // namespace detail

/// The n - 1 modes, the critical force first: the eigenvectors of the n - 1 eigenvalues of B^-1 A that are
/// largest in absolute value, F_x = -1 / lambda (35). The two smallest are the double zero. Vectors (q, F_y)
/// have norm 1 and q_1 > 0.
/// \throws Error for n = 1, a mechanism, or eigenvalues that rounding has made
/// useless (not negative)
template <Floating Real>
std::vector<Mode<Real>> algorithm1(const Chain<Real>& chain) {
  using std::abs;
  const std::size_t modes = mode_count(chain);
  const auto n = static_cast<Eigen::Index>(chain.size());
  const Matrix<Real> C = algorithm1_matrix(chain);
  const Eigen::EigenSolver<Matrix<Real>> solver(C);
  const auto lambda = [&](Eigen::Index i) { return solver.eigenvalues()(i).real(); };
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n) + 1);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return abs(lambda(i)) > abs(lambda(j)); });

  const auto vectors = solver.eigenvectors();  // complex; computed anew at each call
  std::vector<Mode<Real>> result;
  for (std::size_t m = 0; m < modes; ++m) {
    const Eigen::Index i = order[m];
    if (!(lambda(i) < Real(0))) {
      throw Error("Algorithm 1", "eigenvalue " + std::to_string(m + 1) + " of B^-1 A not negative",
                  "more digits for this chain than the number type has");
    }
    const Vector<Real> v = detail::checked_eigenvector<Real>(C, lambda(i), vectors.col(i).real());
    result.push_back({Real(-1) / lambda(i), std::vector<Real>(v.data(), v.data() + n), v(n)});
  }
  return result;
}

}  // namespace plumbline
