#include "proofs/exact/shape_enclosure.hpp"

#include <doctest/doctest.h>

#include "proofs/exact/decimal.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a shape between two forces is that of a uniform string, and is none where they are far apart") {
  // z = 1, 1/2, 1/3 and k = z^2: two beads of mass 1, spaced 1, deflect by sin(m pi i / 3), with the force
  // 4 sin^2(m pi / 6) = 1 or 3; each joint turns by i times the slope: (1, 0, -3) and (1, -4, 3)
  const Chain<Rational> chain({Rational(1, 2), Rational(1, 6), Rational(1, 3)},
                              {1, Rational(1, 4), Rational(1, 9)});
  REQUIRE(parts(chain).size() == 1);
  const ChainPart part = parts(chain)[0];
  const auto near = [&](int force, const Rational& width, int digits) {
    return enclose_shape(chain, part, force - width, force + width, digits);
  };
  const Rational close(1, mp::pow(Integer(10), 30));
  const auto arch = near(1, close, 10), zigzag = near(3, close, 10);
  REQUIRE(arch);
  REQUIRE(zigzag);
  CHECK(arch->part == part);
  CHECK(arch->digits == 10);
  CHECK(arch->q == std::vector<std::string>{"-0.3333333333", "0", "1"});
  CHECK(zigzag->q == std::vector<std::string>{"-0.2500000000", "1", "-0.7500000000"});
  // of a force known to 1e-5 an angle is known to about as much
  const Rational wide(1, 100000);
  CHECK(near(3, wide, 3));
  CHECK_FALSE(near(3, wide, 8));
  CHECK_FALSE(near(1, wide, 8));
  // and of any force at all nothing is
  CHECK_FALSE(enclose_shape(chain, part, Rational(1, 10), 10, 2));
}
