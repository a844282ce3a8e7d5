#include "proofs/exact/polynomial.hpp"

#include <doctest/doctest.h>

#include <plumbline/base/error.hpp>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a polynomial is recovered from its values, at any number of points that suffices") {
  const Polynomial p{Rational(1, 3), 0, -2, Rational(5, 7)};
  for (const long points : {4, 5, 9}) {
    std::vector<Rational> values;
    for (long x = 0; x < points; ++x) values.push_back(evaluate(p, x));
    CHECK(interpolate(values) == p);
    values[3] += 1;
    CHECK(interpolate(values) != p);
  }
  CHECK(interpolate({0, 0, 0}).empty());
}

TEST_CASE("Sturm's count sees distinct roots, on one side of zero, without the zero") {
  const Polynomial p{0, 0, 4, 8, 5, 1};  // x^2 (x + 1) (x + 2)^2
  CHECK(distinct_negative_roots(p) == 2);
  CHECK(distinct_positive_roots(p) == 0);
  CHECK(multiplicity_of_zero(p) == 2);
  CHECK(distinct_negative_roots({1, 0, 1}) == 0);
  CHECK(distinct_positive_roots({-6, 11, -6, 1}) == 3);
  CHECK(distinct_positive_roots({1, -2, 1}) == 1);
  CHECK(distinct_negative_roots({Rational(-1, 10), 0, 1}) == 1);
  CHECK_THROWS_AS(distinct_negative_roots({}), Error);
}
