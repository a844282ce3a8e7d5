/// The torque laws of the wider catalogue, in closed form for one joint and in balance for three.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/chain_values.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

constexpr double spring_stiffness = 2, arm_length = 0.5;

/// One joint under a transverse force that takes these values one after the other.
Experiment one_joint(const std::vector<double>& forces, double interval = 1) {
  Experiment experiment = three_links();
  experiment.link_length = {arm_length};
  experiment.joint_stiffness = {spring_stiffness};
  experiment.link_mass = {0};
  Run run{"load", Control::force, {0.0}, {}};
  for (const double force : forces)
    run.readings.push_back(
        {interval * static_cast<double>(run.readings.size()), chain_values(0, 0, 0, force, {0})});
  experiment.runs.push_back(run);
  return experiment;
}

/// From one value to the next in steps.
std::vector<double> steps_through(const std::vector<double>& corners, int steps) {
  std::vector<double> all{corners.front()};
  for (std::size_t c = 1; c < corners.size(); ++c)
    for (int i = 1; i <= steps; ++i)
      all.push_back(corners[c - 1] + (corners[c] - corners[c - 1]) * static_cast<double>(i) / steps);
  return all;
}

double moment(const Trace& trace, Eigen::Index row) {
  return arm_length * std::cos(angle(trace, row, 0)) * trace(row, column_Fy);
}

Trace predicted_run(const Experiment& experiment, const Candidate& candidate,
                    const std::vector<double>& value) {
  const Prediction prediction = predict(Study(experiment), candidate, value);
  REQUIRE(prediction.reached);
  return prediction.runs[0];
}

/// Moment of the end force about each joint, and the joint's deflection.
struct Balance {
  std::array<double, 3> moment, deflection;
};

std::vector<Balance> balances(const Experiment& experiment, const Trace& trace) {
  std::vector<Balance> all;
  for (Eigen::Index row = 0; row < trace.rows(); ++row) {
    Balance& one = all.emplace_back();
    double x = trace(row, column_x), y = trace(row, column_y), theta = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      one.moment[i] = x * trace(row, column_Fy) - y * trace(row, column_Fx);
      one.deflection[i] = angle(trace, row, i) - experiment.runs[0].rest[i];
      theta += angle(trace, row, i);
      x -= experiment.link_length[i] * std::cos(theta);
      y -= experiment.link_length[i] * std::sin(theta);
    }
  }
  return all;
}

Experiment cycle() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0.01}, 40, true);
  return experiment;
}

constexpr double solver_accuracy = 1e-8;

}  // namespace

TEST_CASE("each joint slips at its own friction; equal values are joint_friction") {
  const Experiment experiment = cycle();
  const std::vector<double> tau{0.01, 0.03, 0.005};
  const Trace trace = predicted_run(experiment, only("friction_spread"), tau);
  std::array<int, 3> slips{};
  for (const Balance& one : balances(experiment, trace)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double carried = std::abs(one.moment[i] - experiment.joint_stiffness[i] * one.deflection[i]);
      CHECK(carried <= tau[i] * (1 + 1e-6));
      slips[i] += carried > tau[i] * (1 - 1e-6);
    }
  }
  for (const int count : slips) CHECK(count > 10);
  CHECK(difference(predicted_run(experiment, only("friction_spread"), {0.02, 0.02, 0.02}),
                   predicted_run(experiment, only("joint_friction"), {0.02})) == 0);
}

TEST_CASE("hardening at each joint, asymmetric springs, stops at every joint") {
  const Experiment experiment = cycle();
  const std::vector<double> c{1.5, -0.5, 4};
  const std::vector<double>& k = experiment.joint_stiffness;
  const auto torque = [](double value) { return doctest::Approx(value).epsilon(solver_accuracy).scale(1); };
  for (const Balance& one : balances(experiment, predicted_run(experiment, only("hardening_spread"), c)))
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = one.deflection[i];
      CHECK(one.moment[i] == torque(k[i] * d * (1 + c[i] * d * d)));
    }
  for (const Balance& one : balances(experiment, predicted_run(experiment, only("asymmetric_spring"), {0.2})))
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = one.deflection[i];
      CHECK(one.moment[i] == torque(k[i] * d * (d > 0 ? 1.2 : 0.8)));
    }
  for (const Balance& one : balances(experiment, predicted_run(experiment, only("joint_stops"), {0.1, 3.0})))
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = one.deflection[i], excess = std::max(0.0, std::abs(d) - 0.1);
      CHECK(one.moment[i] == torque(k[i] * d + std::copysign(3.0 * excess, d)));
    }
  CHECK(difference(predicted_run(experiment, only("hardening_spread"), {2, 2, 2}),
                   predicted_run(experiment, only("nonlinear_spring"), {2})) == 0);
}

TEST_CASE("springs that soften beyond an angle, at all joints and at one") {
  const Experiment experiment = cycle();
  const std::vector<double>& k = experiment.joint_stiffness;
  const double s = 0.05, a = 0.4;
  const auto balanced = [&](const Candidate& candidate, const std::function<bool(std::size_t)>& gives) {
    std::array<int, 3> beyond{}, within{};
    for (const Balance& one : balances(experiment, predicted_run(experiment, candidate, {s, a})))
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = one.deflection[i], over = gives(i) ? std::max(0.0, std::abs(d) - s) : 0;
        CHECK(one.moment[i] ==
              doctest::Approx(k[i] * (d - a * std::copysign(over, d))).epsilon(solver_accuracy).scale(1));
        (std::abs(d) > s ? beyond : within)[i] += 1;
      }
    for (const auto& counted : {beyond, within})
      CHECK(*std::max_element(counted.begin(), counted.end()) > 10);
  };
  balanced(only("piecewise_spring"), [](std::size_t) { return true; });
  balanced(only("piecewise_spring", 2), [](std::size_t joint) { return joint == 1; });
}

TEST_CASE(
    "a piecewise spring without softening, or beyond its range, is plain; with threshold zero it is softer") {
  const Experiment experiment = cycle();
  const Trace nominal = predicted_run(experiment, {}, {});
  for (const std::size_t joint : {0U, 2U}) {
    const Candidate gives = only("piecewise_spring", joint);
    CHECK(difference(predicted_run(experiment, gives, {0.05, 0}), nominal) == 0);
    CHECK(difference(predicted_run(experiment, gives, {2, 0.4}), nominal) == 0);
  }
  // The remaining difference is the torque a k s, which changes forces of newtons and angles in proportion to
  // s.
  const auto left = [&](double s) {
    return difference(predicted_run(experiment, only("piecewise_spring", 2), {s, 0.4}),
                      predicted_run(experiment, only("joint_stiffness", 2), {std::log1p(-0.4)}));
  };
  CHECK(left(1e-4) == close_to(left(2e-4) / 2).epsilon(0.02));
  const Experiment one = one_joint({0.3, 0.6});
  const Trace bent = predicted_run(one, only("piecewise_spring", 1), {0.01, 0.4});
  for (const Eigen::Index row : {0, 1})
    CHECK(moment(bent, row) ==
          close_to(spring_stiffness * (0.6 * angle(bent, row, 0) + 0.4 * 0.01)).epsilon(solver_accuracy));
}

TEST_CASE("piecewise springs are identified, at all joints or at one, and not taken for softening or stops" *
          doctest::test_suite("long")) {
  Experiment experiment = cycle();
  press(experiment, {-0.4, 0.6, 0.3}, {-0.05, 0.03}, 40, true);
  press(experiment, {0.4, 0.3, -0.6}, {-0.06, 0.02}, 40, true);
  const std::vector<std::pair<Candidate, std::vector<double>>> planted{
      {only("piecewise_spring"), {0.08, 0.4}},
      {only("piecewise_spring", 2), {0.1, 0.5}},
      {only("nonlinear_spring"), {-1.5}},
      {only("joint_stop", 2), {0.05, 3}}};
  for (const auto& [cause, value] : planted) {
    CAPTURE(cause.label());
    const Diagnosis diagnosis = diagnose::diagnose(Study(measured(experiment, cause, value, 11)));
    REQUIRE(diagnosis.cause.ranking.front().cause.label() == cause.label());
    for (std::size_t i = 1; i < diagnosis.cause.named; ++i)
      for (const auto& [other, unused] : planted)
        CHECK(diagnosis.cause.ranking[i].cause.label() != other.label());
    REQUIRE(diagnosis.estimates.front().size() == value.size());
    for (std::size_t p = 0; p < value.size(); ++p) {
      const Estimate& own = diagnosis.estimates.front()[p];
      const double deviation = (own.high - own.low) / (2 * 1.96);
      CHECK(std::abs(own.value - value[p]) < 5 * deviation);
    }
  }
}

TEST_CASE("a Jenkins element: Masing's rule, and a closed loop leaves no memory") {
  // Loading, unloading to a half, reloading and beyond: Masing's rules.
  const int steps = 50;
  const Trace trace = predicted_run(one_joint(steps_through({0, 0.4, 0.2, 0.4, 0.6}, steps)),
                                    only("hysteresis", 1), {0.5, 0.03, 0, 1, 0, 1});
  const double yield = 0.5 * spring_stiffness * 0.03;
  const auto virgin = [&](double q) {
    return spring_stiffness * q + std::min(0.5 * spring_stiffness * q, yield);
  };
  const auto branch = [&](double turn) {
    return spring_stiffness * turn + std::min(0.5 * spring_stiffness * turn, 2 * yield);
  };
  const auto torque = [](double value) { return doctest::Approx(value).epsilon(solver_accuracy).scale(1); };
  const Eigen::Index turn = steps, back = 2 * steps, closed = 3 * steps;
  for (Eigen::Index row = 0; row <= turn; ++row)
    CHECK(moment(trace, row) == torque(virgin(angle(trace, row, 0))));
  for (Eigen::Index row = turn; row <= back; ++row)
    CHECK(moment(trace, turn) - moment(trace, row) ==
          torque(branch(angle(trace, turn, 0) - angle(trace, row, 0))));
  for (Eigen::Index row = back; row <= closed; ++row)
    CHECK(moment(trace, row) - moment(trace, back) ==
          torque(branch(angle(trace, row, 0) - angle(trace, back, 0))));
  CHECK(angle(trace, closed, 0) == close_to(angle(trace, turn, 0)).epsilon(solver_accuracy));
  for (Eigen::Index row = closed; row < trace.rows(); ++row)
    CHECK(moment(trace, row) == torque(virgin(angle(trace, row, 0))));
}

TEST_CASE("a very stiff element is dry friction, one that never slips a stiffer spring") {
  const Experiment experiment = cycle();
  // r k is as stiff as a contact that sticks; a joint of mean stiffness 1.5 yields at 0.02 N m.
  const double r = 1e5;
  CHECK(difference(predicted_run(experiment, only("hysteresis"), {r, 0.02 / (r * 1.5), 0, 1, 0, 1}),
                   predicted_run(experiment, only("joint_friction"), {0.02})) < solver_accuracy);
  CHECK(difference(predicted_run(experiment, only("hysteresis", 2), {0.3, 9, 0, 1, 0, 1}),
                   predicted_run(experiment, only("joint_stiffness", 2), {std::log1p(0.3)})) <
        solver_accuracy);
}

TEST_CASE("friction that gives is a spring until it slips; one that gives next to nothing is dry friction") {
  const double tau = 0.06, d_s = 0.05;
  const Candidate gives{{EffectAt(other_form("joint_friction"))}};
  const int steps = 40;
  const Experiment bench = one_joint(steps_through({0, 0.6, 0}, steps));
  const Trace trace = predicted_run(bench, gives, {tau, std::log(d_s)});
  const double end = angle(trace, steps, 0);
  for (Eigen::Index row = 0; row < trace.rows(); ++row) {
    const double q = angle(trace, row, 0);
    const double carried = row <= steps ? std::min(q / d_s, 1.0) : std::max(1 - (end - q) / d_s, -1.0);
    CHECK(moment(trace, row) - spring_stiffness * q == doctest::Approx(tau * carried).scale(1).epsilon(1e-8));
  }
  CHECK(difference(trace, predicted_run(bench, only("hysteresis", 1),
                                        {tau / (d_s * spring_stiffness), d_s, 0, 1, 0, 1})) <
        solver_accuracy);
  CHECK(difference(predicted_run(cycle(), gives, {0.02, std::log(1e-9)}),
                   predicted_run(cycle(), only("joint_friction"), {0.02})) == 0);
}

TEST_CASE("friction that grows with the deflection") {
  const Trace trace =
      predicted_run(one_joint(steps_through({0, 0.6, 0}, 40)), only("load_friction"), {0.03, 5});
  for (const Eigen::Index row : {20, 40, 75}) {
    const double q = angle(trace, row, 0), way = row > 40 ? -1 : 1;
    CHECK(moment(trace, row) - spring_stiffness * q == close_to(way * 0.03 * (1 + 5 * q)).epsilon(1e-6));
  }
  CHECK(difference(predicted_run(cycle(), only("load_friction"), {0.02, 0}),
                   predicted_run(cycle(), only("joint_friction"), {0.02})) == 0);
}

TEST_CASE("friction that is larger in one direction") {
  const Trace trace =
      predicted_run(one_joint(steps_through({0, 0.6, 0}, 40)), only("direction_friction"), {0.03, 0.4});
  for (const Eigen::Index row : {20, 40, 75})
    CHECK(moment(trace, row) - spring_stiffness * angle(trace, row, 0) ==
          close_to(row > 40 ? -0.03 * 0.6 : 0.03 * 1.4).epsilon(1e-6));
}

TEST_CASE("speed-dependent friction: the speed of the last interval, scaled by the command's") {
  Experiment experiment = one_joint(steps_through({0, 0.6}, 40));
  std::vector<Reading>& readings = experiment.runs.front().readings;
  // After a steady drive the last steps take seven times as long.
  for (std::size_t r = 38; r < readings.size(); ++r) readings[r].t += 6.0 * static_cast<double>(r - 37);
  const double speed = 0.01;
  const Trace trace = predicted_run(experiment, only("speed_friction"), {0.03, -0.5, std::log(speed)});
  for (const std::size_t r : {20U, 37U, 38U, 40U}) {
    const auto row = static_cast<Eigen::Index>(r);
    // The force grows by the same in every step.
    const double v =
        (angle(trace, row - 1, 0) - angle(trace, row - 2, 0)) / (readings[r].t - readings[r - 1].t);
    CHECK(moment(trace, row) - spring_stiffness * angle(trace, row, 0) ==
          close_to(0.03 * (1 - 0.5 * std::exp(-v / speed))).epsilon(1e-6));
  }
}

TEST_CASE("a torque beyond the yield moves the rest angle by slope times the excess over k") {
  const Trace trace =
      predicted_run(one_joint(steps_through({0, 0.6, 0, 0.3}, 30)), only("plastic_set"), {0.15, 0.25});
  const double largest = moment(trace, 30), set = 0.25 * (largest - 0.15) / spring_stiffness;
  CHECK(largest > 0.25);
  CHECK(angle(trace, 10, 0) == close_to(moment(trace, 10) / spring_stiffness));
  CHECK(angle(trace, 30, 0) == close_to(largest / spring_stiffness + set));
  CHECK(angle(trace, 60, 0) == close_to(set));
  // Below what it has carried it is a spring about its new rest.
  CHECK(angle(trace, 90, 0) - set == close_to(moment(trace, 90) / spring_stiffness));
}

TEST_CASE("a held chain relaxes with two time constants; two arms of equal ones are one arm") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 1, false, 1e-6);
  Run& run = experiment.runs[0];
  for (int i = 1; i <= 30; ++i) {
    run.readings.push_back(run.readings[1]);
    run.readings.back().t = 1e-6 + 5.0 * i;
  }
  const Trace trace =
      predicted_run(experiment, only("relaxation_spectrum"), {0.4, std::log(10.0), 0.2, std::log(60.0)});
  const double nominal = predicted_run(experiment, {}, {})(1, column_Fx);
  for (Eigen::Index row = 1; row < trace.rows(); ++row) {
    const double held = 5.0 * static_cast<double>(row - 1);
    CHECK(trace(row, column_Fx) ==
          close_to((1 + 0.4 * std::exp(-held / 10) + 0.2 * std::exp(-held / 60)) * nominal).epsilon(1e-5));
  }
}

TEST_CASE("a tendon's loss is what exp(-mu) takes from each rest angle beyond the first") {
  const std::vector<double> rest{0.3, -0.5, 0.4};
  const Experiment commanded = cycle();
  Experiment lost = commanded;
  for (std::size_t i = 0; i < 3; ++i)
    lost.runs[0].rest[i] = rest[i] * std::exp(-0.05 * static_cast<double>(i));
  CHECK(difference(predicted_run(commanded, only("tendon_friction"), {0.05}), predicted_run(lost, {}, {})) <
        solver_accuracy);
}
