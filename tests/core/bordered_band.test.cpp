#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <limits>
#include <plumbline/base/bordered_band.hpp>
#include <random>

#include "tests/close_to.hpp"

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

TEST_CASE("rows of zeros in a band are solved and counted in any unit") {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> entry(-2, 2), order(2, 8), borders(1, 3), exponent(-300, 300);
  std::bernoulli_distribution empty(0.3);
  int solved = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Index n = order(random), p = borders(random);
    Band<double, 1> T(2, n);
    for (Eigen::Index i = 0; i < n; ++i) T(0, i) = entry(random), T(1, i) = entry(random);
    bool any_empty = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      if (!empty(random)) continue;
      any_empty = true;
      T(0, i) = T(1, i) = 0;
      if (i > 0) T(1, i - 1) = 0;
    }
    Matrix<double> K = Matrix<double>::Zero(n + p, n + p);
    for (Eigen::Index i = 0; i < n; ++i) {
      K(i, i) = T(0, i);
      if (i + 1 < n) K(i, i + 1) = K(i + 1, i) = T(1, i);
    }
    for (Eigen::Index a = n; a < n + p; ++a) {
      for (Eigen::Index i = 0; i <= a; ++i) K(i, a) = K(a, i) = entry(random);
    }
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    if (eigenvalues.cwiseAbs().minCoeff() < 1e-2) continue;  // singular, or not close to it
    // a band of zeros alone tells no unit
    if (!any_empty || K.topLeftCorner(n, n).isZero()) continue;
    ++solved;
    Vector<double> right(n + p);
    for (double& x : right) x = entry(random);
    const double unit = std::ldexp(1.0, exponent(random));
    CAPTURE(K);
    CAPTURE(unit);
    BorderedBand<double, 1> matrix;
    matrix.factor(unit * T);
    const Matrix<double> C = unit * K.topRightCorner(n, p);
    REQUIRE(matrix.border(C, C, unit * K.bottomRightCorner(p, p)));
    CHECK(matrix.negative(p) == static_cast<std::size_t>((eigenvalues.array() < 0).count()));
    Vector<double> v = unit * right.head(n), w = unit * right.tail(p), both(n + p);
    matrix.solve(v, w);
    both << v, w;
    // a pivot kept is at least eps^(1/4) of its row, so each elimination step loses at most 4 digits
    CHECK((K * both - right).norm() <= 1e-7 * (1 + both.norm()));
  }
  CHECK(solved > 200);
}

TEST_CASE("parts of a band in units far apart are solved as each alone") {
  // [2 1; 1 2] (1, 1) = (3, 3), and the same in other units behind it: what is small beside the other part is
  // not small in its own
  for (const double unit : {0x1p-70, 1.0, 0x1p70}) {
    CAPTURE(unit);
    Band<double, 1> T(2, 4);
    T << 2, 2, 2 * unit, 2 * unit,  //
        1, 0, unit, 0;
    BorderedBand<double, 1> matrix;
    matrix.factor(T);
    REQUIRE(matrix.no_border());
    CHECK(matrix.negative(0) == 0);
    Vector<double> v(4), none(0);
    v << 3, 3, 3 * unit, 3 * unit;
    matrix.solve(v, none);
    for (const double x : v)
      CHECK(std::abs(x - 1) < 1e-15);  // sums and products of few bits, one quotient each
  }
}

TEST_CASE("a diagonal that is small beside what stands next to it costs no digits, in any unit") {
  // [d 1 0 0; 1 d 0 0; 0 0 1 1; 0 0 1 d] times a unit
  for (const double unit : {1e-30, 1e-10, 1.0, 1e10, 1e30}) {
    for (const double d : {1e-6, -1e-6, 1e-9, 1e-12, 0.0}) {
      CAPTURE(unit);
      CAPTURE(d);
      Band<double, 1> T(2, 4);
      T << d * unit, d * unit, unit, d * unit,  //
          unit, 0, unit, 0;
      BorderedBand<double, 1> matrix;
      matrix.factor(T);
      REQUIRE(matrix.no_border());
      CHECK(matrix.negative(0) == 2);
      Vector<double> v(4), none(0);
      const std::vector<double> x{1, 2, 3, 4};
      v << unit * (d * x[0] + x[1]), unit * (x[0] + d * x[1]), unit * (x[2] + x[3]), unit * (x[2] + d * x[3]);
      matrix.solve(v, none);
      // an enlarged pivot is of the size of its row: a few roundings, and none of them grows
      for (std::size_t i = 0; i < 4; ++i)
        CHECK(v(static_cast<Eigen::Index>(i)) == close_to(x[i]).epsilon(1e-14));
    }
  }
}

TEST_CASE("a matrix that is singular is told, with borders and without, of infinite entries too") {
  Band<double, 1> T(2, 2);
  T << 1, 2,  //
      0, 0;
  BorderedBand<double, 1> matrix;
  matrix.factor(T);
  Matrix<double> C(2, 1), D(1, 1);
  C << 2, 4;
  D << 12;  // 2^2 / 1 + 4^2 / 2
  CHECK_FALSE(matrix.border(C, C, D));
  D << 11;
  CHECK(matrix.border(C, C, D));
  D << std::numeric_limits<double>::infinity();
  CHECK_FALSE(matrix.border(C, C, D));
  T << 1, 0,  //
      0, 0;
  matrix.factor(T);
  CHECK_FALSE(matrix.no_border());
  T << 1, 2,  //
      1, 0;
  matrix.factor(T);
  CHECK(matrix.no_border());
}
