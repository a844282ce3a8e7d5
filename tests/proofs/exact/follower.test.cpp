#include "proofs/exact/follower.hpp"

#include <doctest/doctest.h>

#include <plumbline/structure/structure.hpp>

#include "proofs/exact/real_roots.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// Ziegler's double pendulum, masses 2 and 1, under a follower force beside a dead one of 4 against x.
StraightMotion<Rational> touching(const Rational& follower) {
  Structure<Rational> structure{Chain<Rational>({1, 1}, {1, 1})};
  structure.end_point = {};
  structure.mass = {0, 2, 1};
  structure.loads = {{2, {-follower, 0}, true, LoadKind::follower}, {2, {-4, 0}, true, LoadKind::dead}};
  return straight_motion(structure);
}

}  // namespace

TEST_CASE(
    "a frequency that touches zero is a loss at that factor alone: det(K - F A) = (1 - 6 F)^2, by hand") {
  const auto loss = stability_loss(touching(5), 20);
  CHECK(loss.kind == Motion::divergence);
  CHECK(loss.first);
  CHECK(loss.low < Rational(1, 6));
  CHECK(loss.high >= Rational(1, 6));
  REQUIRE(loss.changes.size() == 3);
  CHECK(loss.changes[0].at == Motion::divergence);
  CHECK(loss.changes[0].above == Motion::stable);
  CHECK(loss.changes[1].above == Motion::flutter);
  CHECK(loss.changes[1].factor.starts_with(
      "0.22872465464964"));  // roots of the discriminant, by another program
  CHECK(motion_at(touching(5), Rational(1, 6)) == Motion::divergence);
  for (const Rational& beside : {Rational(16, 100), Rational(17, 100)})
    CHECK(motion_at(touching(5), beside) == Motion::stable);
}

TEST_CASE("a little less follower makes a window of divergence of the touch, a little more leaves nothing") {
  const Rational little = Rational(1, 1000000000);
  const auto window = stability_loss(touching(5 - little), 15);
  CHECK(window.kind == Motion::divergence);
  REQUIRE(window.changes.size() == 4);
  CHECK(window.changes[0].factor == "0.166664909864263");  // as above
  CHECK(window.changes[1].factor == "0.166668423506108");
  CHECK(window.changes[1].above == Motion::stable);
  const auto none = stability_loss(touching(5 + little), 15);
  CHECK(none.kind == Motion::flutter);
  CHECK(none.factor == "0.228724654620500");
}

TEST_CASE("two equal parts swing at equal frequencies and lose their stability at once") {
  Structure<Rational> structure{Chain<Rational>({1, 1, 1, 1}, {0, 1, 0, 1})};
  structure.across = {{}, Restraint<Rational>::held(), {}};
  structure.mass = {0, 1, 1, 1, 1};
  structure.loads = {{4, {-1, 0}, true, LoadKind::follower}};
  const auto loss = stability_loss(straight_motion(structure), 10);
  CHECK(loss.kind == Motion::divergence);
  CHECK(loss.low < 2);  // of each part, a guided pair with one spring: 2 k / L
  CHECK(loss.high >= 2);
}

TEST_CASE("two equal frequencies that share one shape let the motion grow") {
  // M = 1, K - F A = [[1, F], [0, 1]] at F = 1: one shape for the frequency 1
  StraightMotion<Rational> motion{Matrix<Rational>(2, 2), Matrix<Rational>(2, 2), {1, 1}, {}};
  motion.stiffness << 1, 0, 0, 1;
  motion.load << 0, -1, 0, 0;
  CHECK(motion_at(motion, 0) == Motion::stable);
  CHECK(motion_at(motion, 1) == Motion::flutter);
}

TEST_CASE("half of link 1's length is a mass of a base that moves across") {
  Structure<Rational> structure{Chain<Rational>({1, 1, 1}, {0, 1, 1})};
  structure.base.across = Restraint<Rational>::sprung(5);
  structure.base.turn = Restraint<Rational>::held();
  structure.end_point = {};
  structure.loads = {{3, {-1, 0}, true, LoadKind::follower}};
  CHECK(stability_loss(straight_motion(structure), 10).factor == "1.611572134");  // by another program
}

TEST_CASE("positive roots: each once, ascending, and told from fractions") {
  // (x - 1)^2 (x - 1/3) (x^2 - 2) (x + 1)
  Polynomial p{1};
  for (const Polynomial& factor : {Polynomial{-1, 1}, Polynomial{-1, 1}, Polynomial{Rational(-1, 3), 1},
                                   Polynomial{-2, 0, 1}, Polynomial{1, 1}}) {
    Polynomial product(p.size() + factor.size() - 1, Rational(0));
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < factor.size(); ++j) product[i + j] += p[i] * factor[j];
    p = product;
  }
  CHECK(squarefree(p).size() == 6);
  const PositiveRoots roots(p);
  REQUIRE(roots.all().size() == 3);
  CHECK(roots.as_fraction(roots.all()[0]) == Rational(1, 3));
  CHECK(roots.as_fraction(roots.all()[1]) == Rational(1));
  CHECK(!roots.as_fraction(roots.all()[2]));
  CHECK(roots.reached(roots.all()[2], Rational(3, 2)));
  CHECK(!roots.reached(roots.all()[2], Rational(7, 5)));
}
