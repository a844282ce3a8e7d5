#pragma once
/// \file
/// Algorithm 1 of the paper, as it is written there: the eigenvalues of B^-1 A.
///
/// It is the claim under test and the peer of critical_force.hpp, not the way to compute: B^-1 A is not
/// symmetric and has a defective double zero, so that a floating-point solver loses digits, and it costs
/// O(n^3).

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <numeric>
#include <plumbline/mode.hpp>

namespace plumbline {

/// The matrix B^-1 A of (34).
/// \throws Error for n = 1 or a mechanism
template <Ordered Real>
Matrix<Real> algorithm1_matrix(const Chain<Real>& chain) {
  mode_count(chain);
  return matrix_B(chain).partialPivLu().solve(matrix_A(chain));
}

/// The n - 1 modes, the critical force first: the eigenvectors of the n - 1 eigenvalues of B^-1 A that are
/// largest in absolute value, F_x = -1 / lambda (35). The two smallest are the double zero. Vectors (q, F_y)
/// have norm 1 and q_1 > 0. \throws Error for n = 1, a mechanism, or eigenvalues that rounding has made
/// useless (not negative)
template <Floating Real>
std::vector<Mode<Real>> algorithm1(const Chain<Real>& chain) {
  using std::abs;
  const std::size_t modes = mode_count(chain);
  const auto n = static_cast<Eigen::Index>(chain.size());
  const Eigen::EigenSolver<Matrix<Real>> solver(algorithm1_matrix(chain));
  const auto lambda = [&](Eigen::Index i) { return solver.eigenvalues()(i).real(); };
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n) + 1);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto i, auto j) { return abs(lambda(i)) > abs(lambda(j)); });

  std::vector<Mode<Real>> result;
  for (std::size_t m = 0; m < modes; ++m) {
    const Eigen::Index i = order[m];
    if (!(lambda(i) < Real(0))) {
      throw Error("Algorithm 1", "eigenvalue " + std::to_string(m + 1) + " of B^-1 A not negative",
                  "more digits for this chain than the number type has");
    }
    Vector<Real> v = solver.eigenvectors().col(i).real();
    v /= v(0) < Real(0) ? -v.norm() : v.norm();
    result.push_back({Real(-1) / lambda(i), std::vector<Real>(v.data(), v.data() + n), v(n)});
  }
  return result;
}

}  // namespace plumbline
