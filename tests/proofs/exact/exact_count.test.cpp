#include "proofs/exact/exact_count.hpp"

#include <plumbline/straight/critical_force.hpp>

#include "proofs/exact/working_precision.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// A chain of n links with entries p / q, p and q up to 9; joint `passive` (from 1) has no spring, 0 for
/// none.
Chain<Rational> any_chain(std::size_t n, std::size_t passive) {
  const auto entry = [] { return Rational(*rc::gen::inRange(1, 10), *rc::gen::inRange(1, 10)); };
  std::vector<Rational> length, stiffness;
  for (std::size_t i = 1; i <= n; ++i) {
    length.push_back(entry());
    stiffness.push_back(i == passive ? Rational(0) : entry());
  }
  return Chain<Rational>(length, stiffness);
}

}  // namespace

TEST_CASE("the count in integers is the count in fractions") {
  check_property("any rational chain and force, passive joint anywhere or nowhere", [] {
    const auto n = *rc::gen::inRange<std::size_t>(2, 9);
    const auto chain = any_chain(n, *rc::gen::inRange<std::size_t>(0, n + 1));
    const Rational F(*rc::gen::inRange(0, 400), *rc::gen::inRange(1, 20));
    RC_ASSERT(ExactCount(chain).below(F) == count_below(chain, F));
  });
}

TEST_CASE("a critical force is not below itself") {
  // passive base, then (k, k), three unit links: k / L and 3 k / L, equations (16) and (20) of the paper
  const ExactCount count(Chain<Rational>({1, 1, 1}, {0, 1, 1}));
  CHECK(count.below(1) == 0);
  CHECK(count.below(Rational(1000001, 1000000)) == 1);
  CHECK(count.below(3) == 1);
  CHECK(count.below(Rational(3000001, 1000000)) == 2);
}

TEST_CASE("an interior passive joint splits the chain in two that are counted apart") {
  // links of one; before joint 2 F = k_1 z_2 / (z_1 L_1) = 2, behind it F = k_3 (1 / L_2 + 1 / L_3) = 2
  const ExactCount count(Chain<Rational>({1, 1, 1}, {3, 0, 1}));
  REQUIRE(count.parts().size() == 2);
  CHECK(count.below(2) == 0);
  CHECK(count.below(Rational(2001, 1000)) == 2);
  CHECK(count.below(Rational(2001, 1000), {0, 1}) == 1);
  CHECK(count.below(Rational(2001, 1000), {1, 2}) == 1);
}

TEST_CASE("long chains, counted in intervals, give the count of a hundred digits") {
  const WorkingPrecision precision(100);
  check_property("150 links, passive joint anywhere or nowhere", [] {
    const auto chain = any_chain(150, *rc::gen::inRange<std::size_t>(0, 151));
    const Rational F(*rc::gen::inRange(1, 400), 100000);
    RC_ASSERT(ExactCount(chain).below(F) == count_below(from_rational<Mpfr>(chain), from_rational<Mpfr>(F)));
  });
}

TEST_CASE("a force exactly at which a long chain buckles is not below itself") {
  // "Equal links": F_m = 4 sin^2(m pi / 2n), which is 1 for n = 102, m = 34; counted in intervals, an open
  // sign
  std::vector<Rational> ones(102, 1), stiffness = ones;
  stiffness[0] = 0;
  const ExactCount count(Chain<Rational>(ones, stiffness));
  CHECK(count.below(1) == 33);
  CHECK(count.below(1 + Rational(1, 1000000)) == 34);
}
