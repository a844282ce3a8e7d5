#include "proofs/exact/inertia.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a sign that an off-diagonal entry can turn stays open") {
  for (const double sign : {1.0, -1.0}) {
    Matrix<Span> K = Matrix<Span>::Constant(2, 2, Span(-2, 2));
    K(0, 0) = K(1, 1) = Span(sign);
    CHECK_FALSE(negative_eigenvalues(K));
    K(0, 1) = K(1, 0) = Span(-0.5, 0.5);
    CHECK(negative_eigenvalues(K) == std::size_t{sign > 0 ? 0U : 2U});
  }
}
