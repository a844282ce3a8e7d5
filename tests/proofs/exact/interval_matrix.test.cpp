#include "proofs/exact/interval_matrix.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("products and defects hold those of every matrix inside, entry by entry") {
  std::mt19937 random(6);
  std::uniform_int_distribution<int> some(-64, 64);
  for (const Eigen::Index n : {1, 2, 5}) {
    Eigen::MatrixXd Y(n, n);
    Matrix<Interval> A(n, n);
    Matrix<Rational> inside(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        Y(i, j) = some(random) / 64.0;
        const int middle = some(random);
        A(i, j) = around(middle / 64.0, 1.0 / 1024);
        inside(i, j) = Rational(middle, 64) + Rational(some(random), 1 << 16);
      }
    const Matrix<Interval> D = defect(Y, A);
    const IntervalVector product_of_column = product(Y, IntervalVector(A.col(0)));
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) {
        Rational sum(0);
        for (Eigen::Index k = 0; k < n; ++k) sum += Rational(Y(i, k)) * inside(k, j);
        CHECK(D(i, j).contains(Rational(i == j ? 1 : 0) - sum));
        CHECK(D(i, j).width() < 0.01 * static_cast<double>(n));  // n entries of one and 2^-9 wide
        if (j == 0) CHECK(product_of_column(i).contains(sum));
      }
  }
}
