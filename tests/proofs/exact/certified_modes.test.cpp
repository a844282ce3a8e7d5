#include "proofs/exact/certified_modes.hpp"

#include <doctest/doctest.h>

#include "proofs/exact/decimal.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a force just above half-way between two decimals is certified to be above") {
  // two unit links on a passive base buckle at 2 k
  const Rational half = *parse_decimal("0.1235"), little = *parse_decimal("3e-16");
  for (const int way : {1, -1}) {
    const Rational force = half + way * little;
    const CertifiedModes modes = certify(Chain<Rational>({1, 1}, {0, force / 2}), 1, 1, 3);
    REQUIRE(modes.forces.size() == 1);
    CHECK(modes.forces[0].low <= force);
    CHECK(force <= modes.forces[0].high);
    CHECK(to_decimal(modes.forces[0].low, 3) == to_decimal(force, 3));
    CHECK(to_decimal(modes.forces[0].high, 3) == to_decimal(force, 3));
    CHECK(certified_force(modes, 1) == to_decimal(force, 3));
  }
}

TEST_CASE("each mode has its own certified force") {
  // three unit links on a passive base: 1 and 3
  const CertifiedModes modes = certify(Chain<Rational>({1, 1, 1}, {0, 1, 1}), 2, 0, 20);
  CHECK(certified_force(modes, 1) == to_decimal(Rational(1), 20));
  CHECK(certified_force(modes, 2) == to_decimal(Rational(3), 20));
}
