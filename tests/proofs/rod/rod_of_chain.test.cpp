#include "proofs/rod/rod_of_chain.hpp"

#include <doctest/doctest.h>

#include <plumbline/structure/beam.hpp>

using namespace plumbline;
using namespace plumbline::proofs;

TEST_CASE("a chain of bars stands for the rod with its ends, supports, bed and loads") {
  Structure<Rational> chain = plumbline::rod<Rational>(3, 2, 8, RodEnd::clamped, RodEnd::free);
  chain.end_point.across = Restraint<Rational>::sprung(7);
  chain.across.resize(7);
  chain.across[1] = Restraint<Rational>::sprung(5);
  chain.across[3] = Restraint<Rational>::held();
  chain.add_foundation(11);
  chain.loads.push_back({8, {-1, 0}, true, LoadKind::follower});
  chain.loads.push_back({2, {-4, 0}, false, LoadKind::dead});
  const LinkWeights weights{{1, 1, 1, 1, 2, 2, 2, 2}};
  for (std::size_t link = 1; link <= 8; ++link) chain.add_weight(link, {-weights.weight[link - 1], 0});
  const Rod rod = rod_of_chain(chain, {3, Rational(1, 4), 11, {weights}});
  CHECK(rod.length == 2);
  CHECK(rod.base.turn.is_held());
  CHECK(rod.end_point.turn.is_free());
  CHECK(rod.end_point.across.stiffness == 7);
  CHECK(rod.bed == 11);
  REQUIRE(rod.supports.size() == 2);
  CHECK(rod.supports[0].at == Rational(1, 2));
  CHECK(rod.supports[0].across.stiffness == 5);
  CHECK(rod.supports[1].across.is_held());
  REQUIRE(rod.loads.size() == 2);
  CHECK(rod.loads[0].kind == LoadKind::follower);
  CHECK(rod.loads[1].at == Rational(1, 2));
  CHECK(rod.loads[1].force == 4);
  CHECK_FALSE(rod.loads[1].multiplied);
  REQUIRE(rod.weights.size() == 2);
  CHECK(rod.weights[0].to == 1);
  CHECK(rod.weights[0].per_length == 4);
  CHECK(rod.weights[1].per_length == 8);
}

TEST_CASE("half a bar and a spring against turning at an end") {
  // in series with 2 E I / l = 16 a spring of 16 has 8
  Structure<Rational> chain = plumbline::rod<Rational>(1, 1, 8, RodEnd::pinned, RodEnd::pinned);
  chain.end_point.turn = Restraint<Rational>::sprung(8);
  const Rod rod = rod_of_chain(chain, {1, Rational(1, 8)});
  CHECK(rod.end_point.turn.stiffness == 16);
  CHECK(rod.base.turn.is_free());
}

TEST_CASE("masses and loads that a rod does not have are named") {
  Structure<Rational> chain = plumbline::rod<Rational>(1, 1, 2, RodEnd::clamped, RodEnd::free);
  chain.loads.push_back({2, {0, 1}, true, LoadKind::dead});
  CHECK_THROWS_WITH_AS(rod_of_chain(chain, {1, Rational(1, 2)}), doctest::Contains("across"), Error);
  chain.mass = {0, 1, 1};
  CHECK_THROWS_WITH_AS(rod_of_chain(chain, {1, Rational(1, 2)}), doctest::Contains("masses"), Error);
}
