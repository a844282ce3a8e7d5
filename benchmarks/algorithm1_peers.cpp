#include <Spectra/MatOp/SparseSymShiftSolve.h>
#include <Spectra/SymEigsShiftSolver.h>

#include <Eigen/Eigenvalues>
#include <plumbline/straight/algorithm1.hpp>

#include "benchmarks/peers.hpp"

namespace plumbline::bench {
namespace {

/// (35): the n - 1 eigenvalues that are largest in absolute value, as forces.
template <class Eigenvalues>
Forces forces_of(const Eigenvalues& eigenvalues) {
  std::vector<double> lambda;
  for (Eigen::Index i = 0; i < eigenvalues.size(); ++i) lambda.push_back(eigenvalues(i).real());
  std::sort(lambda.begin(), lambda.end());
  Forces forces;
  for (std::size_t m = 0; m + 2 < lambda.size(); ++m) forces.push_back(-1 / lambda[m]);
  return forces;
}

/// The lowest of them.
template <class Eigenvalues>
auto lowest_of(const Eigenvalues& eigenvalues) {
  auto least = eigenvalues(0).real();
  for (Eigen::Index i = 1; i < eigenvalues.size(); ++i) {
    if (eigenvalues(i).real() < least) least = eigenvalues(i).real();
  }
  return -1 / least;
}

}  // namespace

Forces spectra_lowest(const Chain<double>& chain) {
  const detail::BeadString<double> whole(chain);
  const Tridiagonal T = tridiagonal(whole.pieces()[0]);
  const auto n = static_cast<Eigen::Index>(T.diagonal.size());
  Eigen::SparseMatrix<double> matrix(n, n);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < n; ++i) {
    entries.emplace_back(i, i, T.diagonal[static_cast<std::size_t>(i)]);
    if (i + 1 < n) entries.emplace_back(i + 1, i, T.beside[static_cast<std::size_t>(i)]);
  }
  matrix.setFromTriplets(entries.begin(), entries.end());
  Spectra::SparseSymShiftSolve<double> inverse(matrix);
  Spectra::SymEigsShiftSolver<Spectra::SparseSymShiftSolve<double>> solver(
      inverse, 1, static_cast<int>(std::min<Eigen::Index>(n, 6)), 0.0);
  solver.init();
  solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-14);
  return solver.eigenvalues().size() == 0 ? Forces{NAN} : Forces{solver.eigenvalues()(0)};
}

Forces eigen_self_adjoint_all(const Chain<double>& chain) {
  const detail::BeadString<double> whole(chain);
  const auto string = whole.pieces()[0];
  const auto n = static_cast<Eigen::Index>(string.size());
  Matrix<double> K = Matrix<double>::Zero(n, n), M = Matrix<double>::Zero(n, n);
  double left = string.slope;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto bead = static_cast<std::size_t>(i);
    const double right = bead < string.spacing.size() ? 1 / string.spacing[bead] : 0;
    K(i, i) = left + right;
    if (i + 1 < n) K(i + 1, i) = K(i, i + 1) = -right;
    M(i, i) = string.mass[bead];
    left = right;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix<double>> solver(K, M, Eigen::EigenvaluesOnly);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

Forces eigen_algorithm1_all(const Chain<double>& chain) {
  return forces_of(Eigen::EigenSolver<Matrix<double>>(algorithm1_matrix(chain), false).eigenvalues());
}

double eigen_algorithm1_four_links(const Chain<double>& chain) {
  using Fixed = Eigen::Matrix<double, 5, 5>;
  double z[5] = {0, 0, 0, 0, 0};
  for (int i = 3; i >= 0; --i) z[i] = z[i + 1] + chain.length()[static_cast<std::size_t>(i)];
  Fixed A = Fixed::Zero(), B = Fixed::Zero();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) A(i, j) = -z[std::max(i, j)];
    B(i, i) = chain.stiffness()[static_cast<std::size_t>(i)];
    B(i, 4) = B(4, i) = z[i];
  }
  const Fixed matrix = B.partialPivLu().solve(A);
  return lowest_of(Eigen::EigenSolver<Fixed>(matrix, false).eigenvalues());
}

double eigen_algorithm1_lowest(const Chain<Mpfr50>& chain) {
  return static_cast<double>(
      lowest_of(Eigen::EigenSolver<Matrix<Mpfr50>>(algorithm1_matrix(chain), false).eigenvalues()));
}
double eigen_algorithm1_lowest(const Chain<StockMpfr50>& chain) {
  return static_cast<double>(
      lowest_of(Eigen::EigenSolver<Matrix<StockMpfr50>>(algorithm1_matrix(chain), false).eigenvalues()));
}

}  // namespace plumbline::bench
