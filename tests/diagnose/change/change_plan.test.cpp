#include "diagnose/change/change_plan.hpp"

#include <fmt/format.h>

#include <plumbline/base/error.hpp>

#include "diagnose/bench/unmeasured.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// A long press and a short one.
Experiment bench() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true, 2);
  press(experiment, {0.3, -0.5, 0.4}, {-0.01, 0}, 20, true, 2);
  return unmeasured(std::move(experiment));
}

std::string force_offset(double size) {
  return fmt::format("force_bias={},0", size);
}

}  // namespace

TEST_CASE("the evidence of a shift of a sensor is its square over four variances, a reading") {
  const ChangePlan plan = plan_of_change(bench(), force_offset(0.02));
  const double sigma = bench().noise[Channel::Name::Fx];
  // Twice the variance, and half of the square. The sigma of a reading has what the command passes on too, so
  // that this is the most; the command of this bench has a noise of its own.
  const double most = 41 * std::pow(0.02 / sigma, 2) / 4;
  for (const Repeat& one : plan.runs) {
    CHECK(one.evidence > 0);
    CHECK(one.evidence <= most * (1 + 1e-9));
  }
}

TEST_CASE("evidence grows with the square of what is linear, and the least size is where it begins to do") {
  const ChangePlan one = plan_of_change(bench(), force_offset(0.01)),
                   two = plan_of_change(bench(), force_offset(0.02));
  CHECK(two.runs.front().evidence == close_to(4 * one.runs.front().evidence).epsilon(1e-6));
  // Bisected to a thousandth.
  CHECK(one.least / two.least == close_to(2).epsilon(2e-3));
  CHECK(plan_of_change(bench(), force_offset(0.01 * one.least * 1.01)).fewest == 2);
  CHECK(plan_of_change(bench(), force_offset(0.01 * one.least * 0.99)).fewest == 0);
}

TEST_CASE("the fewest runs are those that tell most") {
  const ChangePlan plan = plan_of_change(bench(), "joint_stiffness(2)=0.3");
  REQUIRE(plan.runs.size() == 2);
  CHECK(plan.runs[0].evidence > plan.runs[1].evidence);
  CHECK(plan.fewest == 1);
}

TEST_CASE("a change that cannot be is refused in a line") {
  CHECK_THROWS_WITH_AS(plan_of_change(bench(), "joint_friction"), doctest::Contains("EFFECT=VALUE"), Error);
  CHECK_THROWS_WITH_AS(plan_of_change(bench(), "joint_friction=a"), doctest::Contains("numbers"), Error);
  CHECK_THROWS_WITH_AS(plan_of_change(bench(), "joint_friction=0.1,2"), doctest::Contains("one a parameter"),
                       Error);
  CHECK_THROWS_WITH_AS(plan_of_change(bench(), "joint_friction=-1"), doctest::Contains("a value from 0"),
                       Error);
  CHECK_THROWS_WITH_AS(plan_of_change(bench(), "joint_stop(x)=1,2"), doctest::Contains("EFFECT(JOINT)"),
                       Error);
  CHECK_THROWS_AS(plan_of_change(bench(), "no_such_effect=1"), Error);
}
