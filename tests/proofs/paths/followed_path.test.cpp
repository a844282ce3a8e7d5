#include "proofs/paths/followed_path.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

PathReport all_branches(std::size_t links) {
  const std::vector<double> ones(links, 1);
  std::vector<double> rest(links, 0.2);
  rest[0] = -0.3;
  return follow_all({Chain<double>(ones, ones, rest), {Control::force, {0, 0}, {-1, 0}}, 0.1, 0.2});
}

}  // namespace

TEST_CASE("branches apart from the unloaded shape are looked for up to five links, and beyond it is said") {
  CHECK(all_branches(2).warnings.empty());
  const PathReport six = all_branches(6);
  REQUIRE(six.warnings.size() == 1);
  CHECK(six.warnings[0].find("more than five links") != std::string::npos);
}

TEST_CASE("a straight chain buckles to the side that is asked for, under compression along its axis alone") {
  const std::vector<double> ones(3, 1);
  const auto pushed = [&](Point<double> direction, int side) {
    return follow_slowly(
        {Chain<double>(ones, ones), {Control::end_point, {3, 0}, direction}, 0.3, 0.2, side});
  };
  const PathReport one = pushed({-1, 0}, 1), other = pushed({-1, 0}, -1);
  CHECK(one.history);
  REQUIRE(one.branches.size() == 1);
  REQUIRE(other.branches.size() == 1);
  const auto &a = one.branches[0].points.back(), &b = other.branches[0].points.back();
  CHECK(a.theta(0) > 0.1);
  CHECK((a.theta + b.theta).norm() < 1e-9);  // mirror images
  CHECK(a.load == 0.3);
  CHECK(one.branches[0].points.front().load < 1e-3);
  CHECK_THROWS_AS(pushed({1, 0}, 1), Error);
  CHECK_THROWS_AS(pushed({-1, 0.1}, 1), Error);
}

TEST_CASE(
    "the state at a load lies on the stretch that reaches it, and is the nearest point where none does") {
  const PathTask task{
      Chain<double>({1, 1, 1}, {1, 1, 1}, {0.2, 0.1, -0.3}), {Control::force, {0, 0}, {-1, 0}}, 0.1, 0.01};
  const PathReport report = follow_slowly(task);
  REQUIRE(report.branches.size() == 1);
  for (const double load : {0.0, 0.03, 0.0777, 0.1}) {
    CAPTURE(load);
    const auto there = state_at(task, report.branches, load);
    CHECK(std::abs(there.load - load) < 1e-15);
    CHECK((there.theta - state_at(task, report.branches[0], load).theta).norm() == 0);
    // in balance: k times the turns against the force times the heights beyond
    double moment = 0;
    for (Eigen::Index i = 2; i >= 0; --i) {
      moment += load * std::sin(there.theta(i));
      const double q = there.theta(i) - (i > 0 ? there.theta(i - 1) : 0);
      CHECK(std::abs(q - task.chain.rest()[static_cast<std::size_t>(i)] - moment) < 1e-9);
    }
  }
  CHECK(state_at(task, report.branches, 0.2).load == report.branches[0].points.back().load);
  CHECK(state_at(task, report.branches, -0.1).load == 0);
}
