#include "diagnose/rig/sensors.hpp"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>
#include <functional>

#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/finger.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using Name = Channel::Name;

const Eigen::ArrayXd times = Eigen::ArrayXd::LinSpaced(9, 0, 4);

Response delay(double seconds) {
  return {.delay = seconds};
}

/// A press of which joint angles and both sensors of the load are read.
Experiment watched_press() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 8, true);
  for (Reading& reading : experiment.runs[0].readings)
    for (std::ptrdiff_t column = column_Fx_2; column < column_q + 3; ++column) reading[column] = 0;
  return experiment;
}

Trace read(const Experiment& experiment, const Candidate& candidate, const std::vector<double>& values) {
  const Prediction predicted = predict(Study(experiment), candidate, values);
  REQUIRE(predicted.reached);
  return predicted.runs[0];
}

/// The form of a row that is told by a delay.
const Effect& late_form(std::string_view id) {
  for (const Effect& row : catalogue())
    if (row.id == id && row.form == "by a delay") return row;
  FAIL("by a delay");
  return catalogue().front();
}

}  // namespace

TEST_CASE("a delay by the interval shows the value before, and the first one before it") {
  const Eigen::ArrayXd values = times.square(), shown = responded(delay(0.5), times, values);
  CHECK(shown(0) == values(0));
  for (Eigen::Index i = 1; i < times.size(); ++i) CHECK(shown(i) == close_to(values(i - 1)));
}

TEST_CASE("a lag trails a ramp by rate (1 - exp(-t / tau)) tau") {
  constexpr double rate = 3, tau = 0.7;
  const Eigen::ArrayXd shown = responded({.lag = tau}, times, rate * times);
  for (Eigen::Index i = 0; i < times.size(); ++i)
    CHECK(rate * times(i) - shown(i) == close_to(rate * tau * (1 - std::exp(-times(i) / tau))));
}

TEST_CASE("a response is linear, keeps constants and leaves out what is not known") {
  rc::check("a response to a sum is that of the parts; a constant stays", [] {
    const auto tenths = [] { return 0.1 * *rc::gen::inRange(-20, 21); };
    const Response how{.delay = std::abs(tenths()), .lag = std::abs(tenths()), .creep = std::abs(tenths())};
    Eigen::ArrayXd a(times.size()), b(times.size());
    for (Eigen::Index i = 0; i < times.size(); ++i) a(i) = tenths(), b(i) = tenths();
    const Eigen::ArrayXd whole = responded(how, times, a + b),
                         parts = responded(how, times, a) + responded(how, times, b);
    RC_ASSERT((whole - parts).abs().maxCoeff() < 1e-12);
    const Eigen::ArrayXd still = Eigen::ArrayXd::Constant(times.size(), 2);
    RC_ASSERT((responded(how, times, still) - 2 * (1 + how.creep)).abs().maxCoeff() < 1e-12);
  });
  Eigen::ArrayXd gap = 2 * times;  // a line: nothing changes where one of its values is missing
  gap(4) = std::nan("");
  const Eigen::ArrayXd shown = responded({.delay = 0.5, .lag = 0.3}, times, gap),
                       whole = responded({.delay = 0.5, .lag = 0.3}, times, 2 * times);
  CHECK(std::isnan(shown(4)));
  for (const Eigen::Index i : {3, 5, 8}) CHECK(shown(i) == close_to(whole(i)));
}

TEST_CASE("sensors of joints show zero, scale, drift and cross-talk of their neighbours") {
  const Experiment experiment = watched_press();
  const Trace stands = read(experiment, {}, {});
  const auto q = [](std::size_t joint) { return Channel(Name::q, joint).column; };
  const auto check = [&](const char* id, double value, const Eigen::ArrayXd& expected) {
    CAPTURE(id);
    const Trace shown = read(experiment, {{{id, 2}}}, {value});
    CHECK((shown.col(q(1)) - expected).abs().maxCoeff() < 1e-12);
    for (const std::ptrdiff_t other : {q(0), q(2), std::ptrdiff_t{column_Fx}})
      CHECK((shown.col(other) - stands.col(other)).abs().maxCoeff() == 0);
  };
  Eigen::ArrayXd t(stands.rows());
  for (Eigen::Index r = 0; r < t.size(); ++r)
    t(r) = experiment.runs[0].readings[static_cast<std::size_t>(r)].t;
  check("angle_bias", 0.01, stands.col(q(1)) + 0.01);
  check("angle_scale", 0.02, 1.02 * stands.col(q(1)));
  check("angle_drift", 1e-3, stands.col(q(1)) + 1e-3 * t);
  check("angle_cross_talk", 0.03, stands.col(q(1)) + 0.03 * (stands.col(q(0)) + stands.col(q(2))));
}

TEST_CASE("components of the second sensor talk into each other and drift, and the first one stays") {
  const Experiment experiment = watched_press();
  const Trace stands = read(experiment, {}, {}),
              mixed = read(experiment, only("second_cross_talk"), {0.1, -0.2}),
              drifts = read(experiment, only("second_drift"), {0.01, -0.02});
  CHECK((mixed.col(column_Fx_2) - stands.col(column_Fx_2) - 0.1 * stands.col(column_Fy_2)).abs().maxCoeff() <
        1e-12);
  CHECK((mixed.col(column_Fy_2) - stands.col(column_Fy_2) + 0.2 * stands.col(column_Fx_2)).abs().maxCoeff() <
        1e-12);
  const Reading& last = experiment.runs[0].readings.back();
  CHECK(drifts(drifts.rows() - 1, column_Fy_2) - stands(stands.rows() - 1, column_Fy_2) ==
        close_to(-0.02 * last.t));
  CHECK((mixed.col(column_Fx) - stands.col(column_Fx)).abs().maxCoeff() == 0);
}

TEST_CASE(
    "a frame that drifts is offset by rate times time, of an end that is held and of places that are read") {
  Experiment experiment = full_bench();
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.t = 1;
  const Study study(experiment);
  const Prediction drifted = predict(study, only("place_drift"), {1e-3, -2e-3}),
                   offset = predict(study, only("position_offset"), {1e-3, -2e-3});
  REQUIRE(drifted.reached);
  for (std::size_t r = 0; r < experiment.runs.size(); ++r)
    CHECK(difference(drifted.runs[r], offset.runs[r]) == 0);
}

TEST_CASE("a drive that follows its command late leads the joints as the delayed command does") {
  Experiment experiment = three_links();
  Run run{"sweep", Control::force, {0, 0, 0}, {}};
  for (int i = 0; i <= 20; ++i) {
    Reading one{0.5 * i, {}, {0.05 * i, 0.02 * i, 0}};
    for (const std::ptrdiff_t column : {column_Fx, column_Fy}) one[column] = 0;
    for (std::size_t j = 0; j < 3; ++j) Channel(Name::q, j).in(one) = 0;
    run.readings.push_back(one);
  }
  experiment.runs = {run};
  experiment.noise[Name::q] = 1e-3;
  const Trace late = read(experiment, only("command_delay"), {0.5}), prompt = read(experiment, {}, {});
  // Nothing loads the joints: they stand where they are commanded.
  for (Eigen::Index r = 1; r < late.rows(); ++r)
    CHECK(late(r, column_q) == doctest::Approx(prompt(r - 1, column_q)).epsilon(1e-9).scale(1));
  const Trace drifts = read(experiment, {{{"command_drift", 2}}}, {1e-3});
  CHECK(drifts(20, column_q + 1) - prompt(20, column_q + 1) == doctest::Approx(1e-3 * 10).epsilon(1e-9));
}

TEST_CASE("a drive of the end goes by a wrong factor of its way from the unloaded end") {
  const std::vector<double> rest{0.3, -0.5, 0.4};
  Experiment experiment = three_links();
  press(experiment, rest, {-0.06, 0.01}, 6, true);
  Experiment farther = experiment;
  const Vector2 start = unloaded_end(experiment, rest);
  for (Reading& reading : farther.runs[0].readings) {
    reading[column_x] += 0.1 * (reading[column_x] - start.x());
    reading[column_y] += 0.1 * (reading[column_y] - start.y());
  }
  const Trace scaled = read(experiment, only("command_scale"), {0.1}), whole = read(farther, {}, {});
  for (const std::ptrdiff_t force : {column_Fx, column_Fy})
    CHECK((scaled.col(force) - whole.col(force)).abs().maxCoeff() < 1e-9);
}

TEST_CASE("a load along the chain is off what is told: by a share, by a factor, over time, late") {
  const std::vector<double> told = there_and_back(12, 5);
  const auto check = [&](const Candidate& cause, double value,
                         const std::function<double(std::size_t reading)>& tension) {
    CAPTURE(cause.name());
    std::vector<double> acts;
    for (std::size_t r = 0; r < told.size(); ++r) acts.push_back(tension(r));
    CHECK(difference(read(finger(told), cause, {value}), read(finger(acts), {}, {})) < 1e-9);
  };
  check(only("applied_bias"), 0.1, [&](std::size_t r) { return told[r] + 0.1 * 12; });
  check(only("applied_drift"), 0.1, [&](std::size_t r) {  // 20 s long, a reading every 2 s
    return told[r] + 0.1 * 12 * static_cast<double>(r) / 10;
  });
  check({{late_form("applied_lag")}}, 2, [&](std::size_t r) { return told[r > 0 ? r - 1 : 0]; });
  // The scale of a single tendon is that of its moment arms.
  const Study study(finger(told));
  CHECK_FALSE(effect("applied_scale").possible({study.scales(), 0}));
  CHECK(difference(read(finger(told), only("applied_scale"), {0.1}),
                   read(finger(told), only("moment_arm"), {0.1})) < 1e-12);
}

TEST_CASE("numbers of one sensor talk into each other, those of two sensors do not") {
  Run run{"poses", Control::force, {0}, {{0, {}, {0}}, {1, {}, {0}}}};
  run.points = 1;
  const Channel u(Channel::of_sensor(Name::pixel, 0, 0, 1, 1)),
      v(Channel::of_sensor(Name::pixel, 0, 1, 1, 1)), other(Channel::of_sensor(Name::pixel, 1, 0, 1, 1));
  run.of_sensors = run.planned = {u, v, other};
  Trace stands = Trace::Zero(2, other.column + 2);
  stands.col(u.column) << 10, 20;
  stands.col(v.column) << 30, 50;
  stands.col(other.column) << 7, 8;
  Sensors sensors;
  for (const std::size_t index : {u.joint, v.joint, other.joint})
    sensors.error(Name::pixel, index).neighbours = 0.5;
  const Trace shown = sensors.shown(run, stands);
  CHECK(shown(1, u.column) == 20 + 25);
  CHECK(shown(1, v.column) == 50 + 10);
  CHECK(shown(1, other.column) == 8);
}
