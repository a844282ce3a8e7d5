/// \file
/// Joints that get a command at every reading: the springs pull from it, and the history goes on between the
/// readings.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/rig/history.hpp"
#include "diagnose/rig/joint_law.hpp"
#include "diagnose/rig/nominal.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

// Newton stops with steps below 1e-7 rad, which leaves errors of their square; dry friction that sticks gives
// by 1e-5 of the deflection that the spring needs for its slip torque.
constexpr double as_near = 1e-9;

Run commanded_run(const std::vector<std::vector<double>>& commands) {
  Run run{"sweep", Control::force, commands.front(), {}};
  for (std::size_t i = 0; i < commands.size(); ++i)
    run.readings.push_back({static_cast<double>(i), {nan_value(), nan_value(), 0, 0}, commands[i]});
  run.by_weights = true;
  return run;
}

/// One joint without weight, swept from 0 to 0.6 rad and back.
Experiment swept_joint(double first = 0) {
  Experiment experiment;
  experiment.name = "one servo";
  experiment.link_length = {0.4};
  experiment.joint_stiffness = {20};
  experiment.link_mass = {0};
  experiment.gravity = {0, 0};
  experiment.noise[Channel::Name::q] = 1e-3;
  std::vector<std::vector<double>> commands;
  for (int i = 0; i <= 24; ++i) commands.push_back({first + 0.05 * (12 - std::abs(12 - i))});
  experiment.runs = {commanded_run(commands)};
  return experiment;
}

double angle_of_joint(const Prediction& predicted, Eigen::Index reading) {
  return predicted.runs[0](reading, column_q);
}

}  // namespace

TEST_CASE("poses in one table are the poses of a run each, where nothing remembers") {
  Experiment together = three_links();
  together.link_mass = {0.03, 0.02, 0.02};
  together.gravity = {0, -9.81};
  // The second and the third are a quarter turn and more from the one before.
  const std::vector<std::vector<double>> poses{
      {0.2, 0.3, -0.4}, {1.8, -0.5, 0.1}, {-0.4, 0.9, 0.6}, {-0.5, 0.8, 0.6}};
  Experiment apart = together;
  together.runs = {commanded_run(poses)};
  for (const auto& pose : poses) {
    apart.runs.push_back(commanded_run({pose}));
    apart.runs.back().readings.front().rest.clear();  // the pose is that of the run
  }
  const Prediction one = simulate(together, nominal_rig(together), {}),
                   each = simulate(apart, nominal_rig(apart), {});
  REQUIRE(one.reached);
  REQUIRE(each.reached);
  CHECK_FALSE(one.snapped);
  for (std::size_t i = 0; i < poses.size(); ++i)
    CHECK((one.runs[0].row(static_cast<Eigen::Index>(i)) - each.runs[i].row(0)).abs().maxCoeff() < as_near);
}

TEST_CASE("dry friction holds the joint back by its torque, and over a reversal by twice its torque") {
  const Experiment experiment = swept_joint();
  Rig rig = nominal_rig(experiment);
  rig.friction = {1.2};
  const double lag = 1.2 / 20, gives = 1e-5 * lag;
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  CHECK(std::abs(angle_of_joint(predicted, 1)) < 2 * gives);  // 0.05 rad ask for 1 N m: it stays
  for (Eigen::Index i = 2; i <= 12; ++i)
    CHECK(angle_of_joint(predicted, i) == doctest::Approx(0.05 * static_cast<double>(i) - lag).epsilon(1e-6));
  for (Eigen::Index i = 13; i <= 14; ++i)  // back by less than twice the lag, 0.12 rad
    CHECK(std::abs(angle_of_joint(predicted, i) - angle_of_joint(predicted, 12)) < 4 * gives);
  for (Eigen::Index i = 15; i <= 24; ++i)
    CHECK(angle_of_joint(predicted, i) ==
          doctest::Approx(0.05 * static_cast<double>(24 - i) + lag).epsilon(1e-6));
}

TEST_CASE("a run that begins moving has slipped before its first reading") {
  Experiment experiment = swept_joint();
  Rig rig = nominal_rig(experiment);
  rig.friction = {1.2};
  experiment.runs[0].begins_moving = true;
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  CHECK(angle_of_joint(predicted, 0) == doctest::Approx(-0.06).epsilon(1e-6));
  CHECK(angle_of_joint(predicted, 1) == doctest::Approx(-0.01).epsilon(1e-5));
  const std::optional<Reading> before = experiment.runs[0].before_first();
  REQUIRE(before);
  CHECK(before->rest[0] == doctest::Approx(-0.2));
  CHECK(before->t == doctest::Approx(-4));
}

TEST_CASE(
    "what creeps or slips in the spring follows the command: without load the joint is where it is sent") {
  const Experiment experiment = swept_joint(-0.3);
  Rig rig = nominal_rig(experiment);
  rig.arms = {{0.5, 3}};
  rig.sliders = {std::vector<Slider>{{0.7, 0.02}}};
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  for (Eigen::Index i = 0; i <= 24; ++i)
    CHECK(std::abs(angle_of_joint(predicted, i) -
                   experiment.runs[0].readings[static_cast<std::size_t>(i)].rest[0]) < as_near);
}

namespace {

/// Two links that hold their weight in three poses.
Experiment heavy_links() {
  Experiment experiment;
  experiment.name = "two servos";
  experiment.link_length = {0.4, 0.3};
  experiment.joint_stiffness = {20, 9};
  experiment.link_mass = {0.7, 0.5};
  experiment.gravity = {0, -9.81};
  experiment.noise[Channel::Name::q] = 1e-3;
  experiment.runs = {commanded_run({{0.2, 0.3}, {0.9, -0.6}, {-0.4, 1.1}})};
  return experiment;
}

}  // namespace

TEST_CASE("servos that hold the whole weight stand where they are sent") {
  const Experiment experiment = heavy_links();
  Rig rig = nominal_rig(experiment);
  rig.compensated = 1;
  const Prediction held = simulate(experiment, rig, {});
  REQUIRE(held.reached);
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index j = 0; j < 2; ++j)
      CHECK(std::abs(
                held.runs[0](r, column_q + j) -
                experiment.runs[0].readings[static_cast<std::size_t>(r)].rest[static_cast<std::size_t>(j)]) <
            as_near);
}

TEST_CASE("a centre of mass off the middle of a link turns its joint by its moment") {
  const Experiment experiment = heavy_links();
  const Vector2 off(0.03, -0.02);
  for (const double flexibility : {0.0, 1e-9}) {  // a link that hardly bends is a rigid one
    Rig rig = nominal_rig(experiment);
    rig.centre[1] = off;
    rig.flexibility = flexibility;
    const Prediction moved = simulate(experiment, rig, {});
    REQUIRE(moved.reached);
    for (Eigen::Index r = 0; r < 3; ++r) {
      const auto& rest = experiment.runs[0].readings[static_cast<std::size_t>(r)].rest;
      const double q1 = moved.runs[0](r, column_q), q2 = moved.runs[0](r, column_q + 1), theta = q1 + q2;
      // k (q - rest) is the moment of the weight about joint 2
      const double arm = (0.15 + off.x()) * std::cos(theta) - off.y() * std::sin(theta);
      CHECK(9 * (q2 - rest[1]) == doctest::Approx(-0.5 * 9.81 * arm).epsilon(1e-6));
    }
  }
}

TEST_CASE("sensitivities along a sweep are those of two rigs") {
  const Experiment experiment = swept_joint();
  Rig rig = nominal_rig(experiment), other = rig;
  rig.friction = {1.2}, other.friction = {1.2 + 1e-4};
  const Prediction predicted = simulate(experiment, rig, {{other, 1e-4}});
  REQUIRE(predicted.reached);
  for (Eigen::Index i = 2; i <= 12; ++i)
    CHECK(predicted.sensitivity[0][0](i, column_q) == doctest::Approx(-1.0 / 20).epsilon(1e-4));
}

TEST_CASE("a joint stops at the ends of its travel while its command goes on") {
  const Experiment experiment = swept_joint(-0.2);  // to 0.4 rad and back
  Rig rig = nominal_rig(experiment);
  rig.travel[0] = {-0.07, 0.31};
  const Prediction predicted = simulate(experiment, rig, {});
  REQUIRE(predicted.reached);
  for (Eigen::Index i = 0; i <= 24; ++i) {
    const double command = experiment.runs[0].readings[static_cast<std::size_t>(i)].rest[0],
                 end = std::clamp(command, -0.07, 0.31);
    // The spring pulls on, against an end that is so many times as stiff.
    CHECK(std::abs(angle_of_joint(predicted, i) -
                   (command + JointLaw::unyielding * end) / (1 + JointLaw::unyielding)) < as_near);
  }
}
