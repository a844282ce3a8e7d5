#include "proofs/census/covering.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// Reads a covering again: whether every box at its leaves holds nothing, or nothing beyond the balls.
struct CoveringReader {
  const EquilibriumBox& system;
  const std::vector<Box>& balls;
  std::string tree;
  std::size_t next = 0, holding = 0;

  /// \param box  with forces that are told by the narrowing alone
  void read(const Box& box) {
    REQUIRE(next < tree.size());
    const char letter = tree[next++];
    Box left = box;
    const bool any = system.narrow(left);
    if (letter == '.') {
      if (!any) return;
      ++holding;
      CHECK(std::any_of(balls.begin(), balls.end(), [&](const Box& ball) {
        for (std::size_t j = 0; j < system.unknowns(); ++j) {
          if (!left[j].inside(ball[j])) return false;
        }
        return true;
      }));
      return;
    }
    REQUIRE(any);
    const auto j = static_cast<std::size_t>(letter - 'a');
    REQUIRE(j == system.widest(left));
    Box half = box;
    half[j].high = box[j].middle();
    read(half);
    half[j] = {box[j].middle(), box[j].high};
    read(half);
  }
};

/// Boxes so far around equilibria.
std::vector<Box> balls_around(const std::vector<std::vector<double>>& equilibria, double radius) {
  std::vector<Box> balls;
  for (const auto& one : equilibria) {
    Box& ball = balls.emplace_back();
    for (std::size_t j = 0; j < one.size(); ++j) ball[j] = Span(one[j] - radius, one[j] + radius);
  }
  return balls;
}

}  // namespace

TEST_CASE("a covering leads to boxes that hold no equilibrium, or none beyond those that are known") {
  // one link, theta = 4 sin theta: straight, and bent to either side
  const double bent = 2.474576787369829;
  const EquilibriumBox one(Chain<Interval>({1}, {1}), Control::force, {Interval(-4), Interval(0)}, {});
  // two unit springs under (3 - sqrt 5) / 2 > 0.3: straight alone
  const EquilibriumBox two(Chain<Interval>({1, 1}, {1, 1}), Control::force,
                           {Interval(Rational(-3, 10)), Interval(0)}, {});
  for (const auto& [system, equilibria] :
       {std::pair{&one, std::vector<std::vector<double>>{{0}, {bent}, {-bent}}}, {&two, {{0, 0}}}}) {
    const std::vector<Box> balls = balls_around(equilibria, 1e-2);
    const std::string tree = covering(*system, balls);
    CoveringReader reader{*system, balls, tree};
    reader.read(system->everything());
    CHECK(reader.next == tree.size());
    CHECK(reader.holding >= equilibria.size());
    // as wide as they may be where the narrowing leads into a ball by itself
    CHECK(tree.size() < 200);
    // an equilibrium that is not among them stays open
    CHECK_THROWS_AS(covering(*system, {balls.begin() + 1, balls.end()}), Error);
  }
}

TEST_CASE("held chains are covered by their angles alone, and passive joints are turned to where a ball is") {
  // two unit links at (3/2, 0): the base at plus or minus acos(3/4), the second joint bent back by twice as
  // much
  const Chain<Interval> chain({1, 1}, {0, 1});
  const Point<Interval> place{Interval(Rational(3, 2)), Interval(0)};
  const EquilibriumBox system(chain, Control::end_point, place, unwound(chain));
  const double a = std::acos(0.75), turn = 2 * std::acos(-1.0);
  // the moment of the second spring about the base is none, so that the force is along the place; its moment
  // about the second joint is k q_2 = -2 a = -F sin a
  const double force = -2 * a / std::sin(a);
  for (const double turns : {0.0, 1.0, -1.0}) {
    CAPTURE(turns);
    const double by = turns * turn;
    const auto balls = balls_around({{a + by, -a + by, force, 0}, {-a + by, a + by, force, 0}}, 1e-2);
    const std::string tree = covering(system, balls);
    CHECK(std::count(tree.begin(), tree.end(), '.') * 2 == static_cast<long>(tree.size()) + 1);
    CHECK(tree.find_first_not_of("ab.") == std::string::npos);
    if (turns == 0) CHECK(tree.size() > 1);
    CHECK_THROWS_AS(covering(system, {balls[0]}), Error);
    // no full turn of the second joint, which has a spring, is the same
    CHECK_THROWS_AS(covering(system, balls_around({{a, -a + turn, force, 0}, {-a, a, force, 0}}, 1e-2)),
                    Error);
  }
}
