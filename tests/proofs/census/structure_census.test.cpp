#include "proofs/census/structure_census.hpp"

#include "proofs/census/census.hpp"
#include "proofs/exact/straight_structure.hpp"
#include "tests/property.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// Free at its end point, where a force acts.
Structure<Rational> under_dead_force(Chain<Rational> chain, const Point<Rational>& force) {
  Structure<Rational> structure(std::move(chain));
  structure.end_point = {};
  structure.loads.push_back({structure.chain.size(), force, true, LoadKind::dead});
  return structure;
}

Structure<Rational> upright(std::size_t n) {
  Structure<Rational> structure{Chain<Rational>(std::vector<Rational>(n, 1), std::vector<Rational>(n, 1))};
  structure.end_point = {};
  for (std::size_t link = 1; link <= n; ++link) structure.add_weight(link, {-1, 0});
  return structure;
}

Rational random_hundredth(int low, int high) {
  return Rational(*rc::gen::inRange(low, high), 100);
}

}  // namespace

TEST_CASE("under a force at a free end point the census is the one of the paper's chain") {
  check_property("census", [] {
    const auto n = static_cast<std::size_t>(*rc::gen::inRange(1, 4));
    std::vector<Rational> length, stiffness, rest;
    for (std::size_t i = 0; i < n; ++i) {
      length.push_back(random_hundredth(50, 150));
      stiffness.push_back(random_hundredth(50, 150));
      rest.push_back(random_hundredth(-50, 50));
    }
    const Chain<Rational> chain(length, stiffness, rest);
    const Point<Rational> force{random_hundredth(-100, -30), random_hundredth(-20, 20)};
    const auto paper =
        census_under_force(from_rational<Interval>(chain), {Interval(force.x), Interval(force.y)});
    const StructureCensus census = take_census(under_dead_force(chain, force), 1, 0);
    RC_ASSERT(paper.complete() && census.complete());
    RC_ASSERT(census.equilibria.size() <=
              paper.equilibria.size());  // the window is half a turn of each joint
    for (const StructureEquilibrium& one : census.equilibria) {
      const auto same =
          std::find_if(paper.equilibria.begin(), paper.equilibria.end(), [&](const auto& other) {
            for (std::size_t i = 0; i < n; ++i) {
              if (std::abs(static_cast<double>(other.q[i].middle()) - one.q[i].middle()) > 1e-9) return false;
            }
            return true;
          });
      RC_ASSERT(same != paper.equilibria.end());
      RC_ASSERT(same->negative_directions == one.negative_directions);
    }
  });
}

TEST_CASE("a heavy column has one equilibrium in the window below its critical weight, three above") {
  // for two links the factor solves (2 - 3F/2)(1 - F/2) = 1: 5/3 -+ sqrt(13)/3, the lower 0.4648
  const auto critical = StraightStructure(upright(2)).enclose(1, 10).front();
  const StructureCensus below = take_census(upright(2), critical.low * Rational(99, 100), 0);
  REQUIRE(below.complete());
  REQUIRE(below.equilibria.size() == 1);
  CHECK(below.equilibria[0].negative_directions == std::size_t{0});
  const StructureCensus above = take_census(upright(2), critical.high * Rational(11, 10), 0);
  REQUIRE(above.complete());
  REQUIRE(above.equilibria.size() == 3);
  CHECK(above.equilibria[0].negative_directions == std::size_t{0});  // by energy: leaning to either side
  CHECK(above.equilibria[1].negative_directions == std::size_t{0});
  CHECK(above.equilibria[2].negative_directions == std::size_t{1});
  CHECK(above.equilibria[0].y.middle() == doctest::Approx(-above.equilibria[1].y.middle()));
}

TEST_CASE("a census names what it does not cover") {
  const auto message = [](const Structure<Rational>& structure) {
    try {
      take_census(structure, 1, 0);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Structure<Rational> rigid = upright(1);
  rigid.end_point.turn = Restraint<Rational>::held();
  CHECK(message(rigid).find("no link that can turn") != std::string::npos);
  Structure<Rational> structure = upright(2);
  structure.loads.back().kind = LoadKind::follower;
  CHECK(message(structure).find("follower") != std::string::npos);
  structure = upright(2);
  structure.base.across = {};
  CHECK(message(structure).find("base that moves") != std::string::npos);
  structure = upright(3);
  structure.across = {Restraint<Rational>::held(), {}};
  CHECK(message(structure).find("between the ends") != std::string::npos);
  CHECK(message(upright(11)).find("at most 10") != std::string::npos);
}
