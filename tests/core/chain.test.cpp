#include <doctest/doctest.h>

#include <plumbline/algorithm1.hpp>
#include <plumbline/chain.hpp>
#include <plumbline/critical_force.hpp>
#include <plumbline/strain_energy.hpp>

using namespace plumbline;

TEST_CASE("a chain refuses what is not a chain, and says where") {
  CHECK_THROWS_WITH_AS(Chain<double>({}, {}), "lengths: found no link, expected at least one", Error);
  CHECK_THROWS_WITH_AS(Chain<double>({1, -1}, {1, 1}),
                       "lengths, entry 2: found a value that is not positive, expected a positive length",
                       Error);
  CHECK_THROWS_AS(Chain<double>({1, NAN}, {1, 1}), Error);
  CHECK_THROWS_AS(Chain<double>({1, INFINITY}, {1, 1}), Error);
  CHECK_THROWS_AS(Chain<double>({1, 1}, {1, -1}), Error);
  CHECK_THROWS_AS(Chain<double>({1, 1}, {1}), Error);
  CHECK_THROWS_AS(Chain<double>({1, 1}, {1, 1}, {0}), Error);
}

TEST_CASE("a single link has no buckling mode, and two passive joints make a mechanism") {
  CHECK_THROWS_AS(mode_count(Chain<double>({1}, {1})), Error);
  CHECK_THROWS_AS(mode_count(Chain<double>({1, 1, 1}, {0, 1, 0})), Error);
  CHECK(mode_count(Chain<double>({1, 1, 1}, {0, 1, 1})) == 2);
}

TEST_CASE_TEMPLATE("Algorithm 1 and the recursion agree on the unit chain of four links", Real, double,
                   Mpfr50) {
  const Chain<Real> chain({1, 1, 1, 1}, {1, 1, 1, 1});
  const auto modes = algorithm1(chain);
  REQUIRE(modes.size() == 3);
  for (std::size_t m = 0; m < 3; ++m) {
    // the error of Algorithm 1 in double on this chain is a few units of 1e-15
    const Real step = Real(64) * epsilon<Real>();
    CHECK(count_below(chain, Real(modes[m].force * (Real(1) - step))) == m);
    CHECK(count_below(chain, Real(modes[m].force * (Real(1) + step))) == m + 1);
  }
}

TEST_CASE("intervals and rationals serve where they make sense") {
  const Chain<Rational> exact({1, 1, Rational(1, 3)}, {0, 1, 2});
  CHECK(strain_energy(exact, {1, 1, 1}) == Rational(3, 2));
  const auto enclosed = from_rational<Interval>(exact);
  const auto p = end_point(enclosed, {Interval(0), Interval(0), Interval(0)});
  CHECK(p.x.contains(Rational(7, 3)));
  CHECK(algorithm1_matrix(exact).rows() == 4);
}
