#include <doctest/doctest.h>

#include <plumbline/chain/chain.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <plumbline/chain/linearised.hpp>
#include <plumbline/chain/strain_energy.hpp>

using namespace plumbline;

TEST_CASE("a chain refuses what is not a chain, and says where") {
  CHECK_THROWS_WITH_AS(Chain<double>({}, {}), "lengths: found no link, expected at least one", Error);
  CHECK_THROWS_WITH_AS(Chain<double>({1, -1}, {1, 1}),
                       "lengths, entry 2: found a value that is not positive, expected a positive length",
                       Error);
  for (const double no_number : {NAN, INFINITY}) {
    CHECK_THROWS_WITH_AS(Chain<double>({1, no_number}, {1, 1}),
                         "lengths, entry 2: found a value that is not finite, expected a finite number",
                         Error);
    CHECK_THROWS_WITH_AS(Chain<double>({1, 1}, {no_number, 1}),
                         "stiffness, entry 1: found a value that is not finite, expected a finite number",
                         Error);
    CHECK_THROWS_WITH_AS(Chain<double>({1, 1}, {1, 1}, {0, no_number}),
                         "rest, entry 2: found a value that is not finite, expected a finite number", Error);
  }
  CHECK_THROWS_WITH_AS(Chain<double>({1, 0}, {1, 1}),
                       "lengths, entry 2: found a value that is not positive, expected a positive length",
                       Error);
  CHECK_THROWS_WITH_AS(Chain<double>({1, 1}, {1, -1}),
                       "stiffness, entry 2: found a negative value, expected zero (passive) or positive",
                       Error);
  CHECK_THROWS_WITH_AS(Chain<double>({1, 1}, {1}), "stiffness: found 1 values, expected one per link, 2",
                       Error);
  CHECK_THROWS_WITH_AS(Chain<double>({1, 1}, {1, 1}, {0}), "rest: found 1 values, expected one per link, 2",
                       Error);
  const Chain<double> passive({1, 1}, {1, 0});
  CHECK(passive.passive_joints() == 1);
  CHECK(passive.passive_joint(1));
  CHECK_FALSE(passive.passive_joint(0));
  CHECK(passive.rest() == std::vector<double>{0, 0});
}

TEST_CASE("a single link has no buckling mode, and two passive joints make a mechanism") {
  CHECK_THROWS_AS(mode_count(Chain<double>({1}, {1})), Error);
  CHECK_THROWS_AS(mode_count(Chain<double>({1, 1, 1}, {0, 1, 0})), Error);
  CHECK(mode_count(Chain<double>({1, 1, 1}, {0, 1, 1})) == 2);
}

TEST_CASE("intervals and rationals serve where they make sense") {
  const Chain<Rational> exact({1, 1, Rational(1, 3)}, {0, 1, 2});
  CHECK(strain_energy(exact, {1, 1, 1}) == Rational(3, 2));
  const auto enclosed = from_rational<Interval>(exact);
  const auto p = end_point(enclosed, {Interval(0), Interval(0), Interval(0)});
  CHECK(p.x.contains(Rational(7, 3)));
  CHECK(matrix_B(exact).rows() == 4);
}
