#include "proofs/census/found_equilibria.hpp"

#include <doctest/doctest.h>

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

CensusTask under(const std::vector<Rational>& stiffness, const Rational& force) {
  const std::vector<Rational> ones(stiffness.size(), Rational(1));
  CensusTask task{"", Chain<Rational>(ones, stiffness), false, Given::force, {force, 0}, 0};
  return task;
}

}  // namespace

TEST_CASE("what floating point finds of a small chain is all that a census proves") {
  // the first: all links in line and the last two folded back, which share q_1 = 0
  for (const CensusTask& task :
       {under({1, 0, 1}, Rational(-1, 2)), under({1, 1}, Rational(-1, 5)), under({1, 1}, -4)}) {
    const Census census = take_census(task);
    REQUIRE(census.complete());
    const FoundEquilibria found = find_equilibria(task);
    CHECK(found.exhausted);
    REQUIRE(found.equilibria.size() == census.equilibria.size());
    for (const FoundEquilibrium& one : found.equilibria) {
      const auto same = std::count_if(
          census.equilibria.begin(), census.equilibria.end(), [&](const CertifiedEquilibrium& other) {
            for (std::size_t i = 0; i < one.q.size(); ++i) {
              const double apart = one.q[i] - static_cast<double>(other.q[i].middle());
              const bool passive = task.chain.stiffness()[i] == 0;
              if (std::abs(passive ? std::remainder(apart, 2 * M_PI) : apart) > 1e-6) return false;
            }
            return other.negative_directions == one.negative_directions;
          });
      CHECK(same == 1);
    }
  }
}

TEST_CASE(
    "equilibria of one link are listed by energy in the units of the chain, and every start is counted") {
  // theta = 4 sin theta, with F = 4 k / L: straight, and bent to either side
  const double bent = 2.474576787369829;
  for (const auto& [length, stiffness] :
       {std::pair<Rational, Rational>{1, 1}, {Rational(1, 1000), 50000}, {3000, Rational(1, 7)}}) {
    const double L = static_cast<double>(length), k = static_cast<double>(stiffness);
    const CensusTask task{"",           Chain<Rational>({length}, {stiffness}), false,
                          Given::force, {-4 * stiffness / length, 0},           0};
    const FoundEquilibria found = find_equilibria(task);
    CHECK(found.starts == 1000);
    CHECK(found.exhausted);
    CHECK(found.window.empty());
    REQUIRE(found.equilibria.size() == 3);
    CHECK(found.equilibria[0].negative_directions == 1);
    CHECK(found.equilibria[1].q[0] * found.equilibria[2].q[0] < 0);
    for (std::size_t i = 0; i < 3; ++i) {
      const FoundEquilibrium& one = found.equilibria[i];
      const auto number = [](const Interval::End& x) { return static_cast<double>(x); };
      const double theta = i == 0 ? 0 : bent;
      // Newton's method, to a few roundings
      CHECK(std::abs(std::abs(one.q[0]) - theta) < 1e-14);
      CHECK(number(one.x) == close_to(L * std::cos(theta)).epsilon(1e-13));
      CHECK(std::abs(std::abs(number(one.y)) - L * std::sin(theta)) < 1e-13 * L);
      CHECK(number(one.fx) == close_to(-4 * k / L).epsilon(1e-15));
      CHECK(number(one.fy) == 0);
      CHECK(std::abs(number(one.energy) - k * theta * theta / 2) < 1e-13 * k);
      CHECK(one.negative_directions == (i == 0 ? 1 : 0));
    }
  }
}

TEST_CASE("two links that are held bend to two sides, and with turns more each joint is wound up as well") {
  // of each side either joint may be at any of 2 turns + 1 angles, a full turn apart
  for (const int turns : {0, 1, 2, 3}) {
    const CensusTask task{"",   Chain<Rational>({1, 1}, {1, 1}), false, Given::end_point, {1, Rational(1, 2)},
                          turns};
    const FoundEquilibria found = find_equilibria(task);
    CHECK(found.starts == 2000);
    CHECK(found.exhausted);
    CHECK(found.equilibria.size() == static_cast<std::size_t>(2 * (2 * turns + 1) * (2 * turns + 1)));
    REQUIRE(found.window.size() == 2);
    for (const FoundEquilibrium& one : found.equilibria) {
      for (std::size_t i = 0; i < 2; ++i) CHECK(std::abs(one.q[i]) <= (2 * turns + 1) * M_PI);
      // Newton's method, to a few roundings
      CHECK(std::abs(std::cos(one.q[0]) + std::cos(one.q[0] + one.q[1]) - 1) < 1e-13);
      CHECK(std::abs(std::sin(one.q[0]) + std::sin(one.q[0] + one.q[1]) - 0.5) < 1e-13);
      CHECK(std::abs(static_cast<double>(one.x) - 1) < 1e-13);
      CHECK(std::abs(static_cast<double>(one.y) - 0.5) < 1e-13);
    }
    CHECK(std::is_sorted(found.equilibria.begin(), found.equilibria.end(),
                         [](const auto& a, const auto& b) { return a.energy < b.energy; }));
  }
  // a base without a spring turns freely: what differs by full turns of it is the same
  const CensusTask passive{
      "", Chain<Rational>({1, 1}, {0, 1}), false, Given::end_point, {-1, Rational(-1, 2)}, 0};
  const FoundEquilibria found = find_equilibria(passive);
  REQUIRE(found.equilibria.size() == 2);
  for (const FoundEquilibrium& one : found.equilibria) CHECK(std::abs(one.q[0]) <= M_PI);
}

TEST_CASE("a place out of a chain's reach is refused in the units of the chain") {
  const auto held_at = [](const std::vector<Rational>& length, const Rational& x) {
    const std::vector<Rational> stiffness(length.size(), Rational(1));
    return find_equilibria({"", Chain<Rational>(length, stiffness), false, Given::end_point, {x, 0}, 0});
  };
  CHECK_THROWS_WITH_AS(held_at({1000, 2000}, 3500),
                       "end point: found distance 3500 from the base, expected between 1000 and 3000, both "
                       "excluded: the reach of the chain",
                       Error);
  CHECK_THROWS_AS(held_at({1000, 2000}, 500), Error);
  CHECK_THROWS_AS(held_at({1000, 2000}, 3000), Error);
  CHECK_THROWS_AS(held_at({1000, 2000}, 1000), Error);
  CHECK(held_at({1000, 2000}, 1500).equilibria.size() == 2);
}
