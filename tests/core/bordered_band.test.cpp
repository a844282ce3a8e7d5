#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <plumbline/base/bordered_band.hpp>
#include <random>

using namespace plumbline;

TEST_CASE("negative eigenvalues of matrices with any diagonal, zeros too, beside those that Eigen computes") {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> entry(-2, 2), order(1, 9);
  std::bernoulli_distribution hollow(0.3);
  int counted = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Eigen::Index n = order(random);
    const bool no_diagonal = hollow(random);
    Matrix<double> G(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) G(i, j) = G(j, i) = i == j && no_diagonal ? 0 : entry(random);
    }
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(G).eigenvalues();
    // Integers: a determinant is at least one, and no eigenvalue exceeds 2 n; nearer to zero than this is
    // zero, of which elimination may make either sign.
    if (eigenvalues.cwiseAbs().minCoeff() < 1e-9) continue;
    ++counted;
    CAPTURE(G);
    Matrix<double> destroyed = G;
    CHECK(negative_eigenvalues(destroyed) == static_cast<std::size_t>((eigenvalues.array() < 0).count()));
  }
  CHECK(counted > 1500);
}
