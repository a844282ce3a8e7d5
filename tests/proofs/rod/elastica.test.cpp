#include "proofs/rod/elastica.hpp"

#include <doctest/doctest.h>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a cantilever bent little carries pi^2 / 4, one bent by a right angle K(1/sqrt 2)^2") {
  const Interval quarter = sqr(Interval::pi()) / Interval(4);
  const BentCantilever little = bent_cantilever(Interval(Rational(1, 1000000)));
  // 1 + angle^2 / 8: Timoshenko and Gere 2.7
  CHECK(
      (little.force / quarter - Interval(1) - Interval(Rational(1, 8)) / Interval(Rational("1000000000000")))
          .inside({-1e-24, 1e-24}));
  const BentCantilever right = bent_cantilever(Interval::pi() / Interval(2));
  // K(1/sqrt 2) = Gamma(1/4)^2 / (4 sqrt pi) = 1.8540746773013719184338503...
  const Interval K(Rational("18540746773013719184338503/10000000000000000000000000"));
  CHECK((right.force - sqr(K)).inside({-1e-23, 1e-23}));
  CHECK(right.force.width() < 1e-55);
  // Legendre: 2 E K - K^2 = pi / 2 there, so that x = 2 E / K - 1 = pi / (2 K^2)
  CHECK((right.x - Interval::pi() / (Interval(2) * right.force)).contains_zero());
}

TEST_CASE("a cantilever pushed across a little bends as a beam: force / 3, and half the force at its tip") {
  const Rational small(1, 1000000);
  const BentCantilever shape = cantilever_pushed_across(Interval(small));
  // the next terms are of order force^3, with coefficients below one
  CHECK((shape.y / Interval(small) - Interval(Rational(1, 3))).inside({-1e-12, 1e-12}));
  CHECK((shape.tip / Interval(small) - Interval(Rational(1, 2))).inside({-1e-12, 1e-12}));
  CHECK(shape.force.contains(small));
  // where the moment is: P x at the clamp, and (P x)^2 = 2 P sin(tip) by the energy of the pendulum
  const BentCantilever far = cantilever_pushed_across(Interval(5));
  CHECK((far.force * sqr(far.x) - Interval(2) * sin(far.tip)).contains_zero());
}
