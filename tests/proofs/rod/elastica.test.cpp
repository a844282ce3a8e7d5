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
