#include "proofs/exact/exact_matrix.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

Matrix<Rational> rows(std::initializer_list<std::initializer_list<Rational>> values) {
  Matrix<Rational> m(static_cast<Eigen::Index>(values.size()),
                     static_cast<Eigen::Index>(values.begin()->size()));
  Eigen::Index i = 0;
  for (const auto& row : values) {
    Eigen::Index j = 0;
    for (const Rational& x : row) m(i, j++) = x;
    ++i;
  }
  return m;
}

}  // namespace

TEST_CASE("determinants: Hilbert's matrix, a swap of rows, a singular matrix") {
  Matrix<Rational> hilbert(4, 4);
  for (long i = 0; i < 4; ++i) {
    for (long j = 0; j < 4; ++j) hilbert(i, j) = Rational(1, i + j + 1);
  }
  CHECK(determinant(hilbert) == Rational(1, 6048000));  // Hilbert 1894
  hilbert.row(0).swap(hilbert.row(2));
  CHECK(determinant(hilbert) == Rational(-1, 6048000));
  CHECK(determinant(rows({{0, 1}, {1, 0}})) == -1);
  CHECK(determinant(rows({{1, 2}, {2, 4}})) == 0);
  CHECK(determinant(rows({{0, 0, 1}, {0, 2, 0}, {3, 0, 0}})) == -6);
}

TEST_CASE("rank of rectangular and deficient matrices") {
  CHECK(rank(rows({{0, 0, 0}, {0, 0, Rational(1, 2)}})) == 1);
  CHECK(rank(rows({{1, 2, 3}, {2, 4, 6}, {1, 0, 0}})) == 2);
  CHECK(rank(rows({{1, 2}, {3, 4}, {5, 6}})) == 2);
  CHECK(rank(rows({{0, 0}, {0, 0}})) == 0);
}

TEST_CASE("a pencil's determinant is a polynomial") {
  const Polynomial p = pencil_determinant(rows({{1, 2}, {3, 4}}), rows({{1, 0}, {0, 1}}));
  CHECK(p == Polynomial{-2, 5, 1});
  CHECK(pencil_determinant(rows({{1, 1}, {1, 1}}), rows({{1, 1}, {1, 1}})).empty());
}
