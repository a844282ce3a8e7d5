#include "proofs/rod/inertia_of_rod.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/proofs/rod/some_rods.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a pinned rod has the squares of frequencies (k pi)^4 - P (k pi)^2 + b, and no other") {
  check_property("count", [] {
    const double load = random_hundredths(-50, 60), bed = random_hundredths(0, 500),
                 below = random_hundredths(-300, 40000);
    std::size_t known = 0;
    for (int k = 1; k < 8; ++k) {
      const double wave = std::pow(k * std::acos(-1.0), 2);
      known += wave * wave - load * wave + bed < below ? 1 : 0;
    }
    Rod rod = compressed_rod(pinned<Rational>(), guided<Rational>());
    rod.bed = Rational(bed);
    RC_ASSERT(negative_directions(divided(rod), Rational(load), Rational(below)) == known);
  });
}

TEST_CASE("a clamped rod has its first frequency at 500.56 and its first critical force at 4 pi^2") {
  const DividedRod rod = divided(compressed_rod(clamped_base(), clamped<Rational>()));
  CHECK(negative_directions(rod, 0, 500) == 0);
  CHECK(negative_directions(rod, 0, 501) == 1);
  CHECK(negative_directions(rod, Rational(39478, 1000), 0) == 0);
  CHECK(negative_directions(rod, Rational(39479, 1000), 0) == 1);
}
