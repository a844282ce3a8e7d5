#include "diagnose/inference/imposed_noise.hpp"

#include <doctest/doctest.h>

#include <rapidcheck.h>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/inference/study.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

constexpr double angle_noise = 1e-3;

/// A joint alone led along a motion, of which a sensor reads the angle.
Experiment led_joint(const std::function<double(double)>& motion, double noise, unsigned seed) {
  Experiment experiment;
  experiment.device = Device::turning_joint;
  experiment.link_length = {1};
  experiment.joint_stiffness = {7};
  experiment.link_mass = {0};
  experiment.noise[Channel::Name::angle] = angle_noise;
  experiment.noise[Channel::Name::torque] = 1e-3;
  Run run{"led", Control::end_point, {0.0}, {}};
  run.device = Device::turning_joint;
  std::mt19937 random(seed);
  std::normal_distribution<double> read(0, noise);
  for (int i = 0; i <= 60; ++i) {
    const double t = 0.5 * i + 0.1 * (i % 3);
    run.readings.push_back({t, {motion(t) + read(random), 0, 0, 0}});
  }
  experiment.runs = {run};
  return experiment;
}

double turning_motion(double t) {
  return 0.3 - 0.02 * std::abs(t - 15);
}

double angle_at(const Experiment& experiment, std::size_t reading) {
  return experiment.runs[0].readings[reading][column_x];
}

}  // namespace

TEST_CASE("a motion of one speed is what was read, whatever the intervals") {
  const Experiment read = led_joint([](double t) { return 0.1 + 0.02 * t; }, 0, 1),
                   moved = with_probable_motion(read);
  // Rounding of a precision of 1e10, in standard deviations.
  for (std::size_t i = 0; i <= 60; ++i)
    CHECK(std::abs(angle_at(moved, i) - angle_at(read, i)) < 1e-3 * angle_noise);
}

TEST_CASE("the motion is nearer to the true one than what was read") {
  for (const auto& motion : std::vector<std::function<double(double)>>{
           turning_motion, [](double t) { return 0.3 * std::sin(0.4 * t); },
           [](double t) { return std::min(0.05 * t, 0.3); }}) {
    double square = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Experiment read = led_joint(motion, angle_noise, seed), moved = with_probable_motion(read);
      for (std::size_t i = 0; i <= 60; ++i)
        square += std::pow(angle_at(moved, i) - motion(read.runs[0].readings[i].t), 2) / 61;
    }
    // Even where every reading changes the speed, its neighbours say something of it.
    CHECK(square / 20 < angle_noise * angle_noise);
  }
}

TEST_CASE("what is measured moves along the nominal model: its residual is that of what was read") {
  const Experiment read = led_joint(turning_motion, angle_noise, 2), moved = with_probable_motion(read);
  const Study before(read), after(moved);
  // A straight model passes on what the motion takes from the angle.
  CHECK((before.nominal_residual() - after.nominal_residual()).norm() <
        1e-9 * (1 + before.nominal_residual().norm()));
}

namespace {

/// A torque of that law over time, with noise beside a noisy angle: 0.2 N m pass on beside 0.02 N m.
Experiment lagging_torque(double lag, unsigned seed) {
  constexpr double stiffness = 100;
  Experiment experiment = led_joint(turning_motion, 2e-3, seed);
  experiment.joint_stiffness = {stiffness};
  experiment.noise[Channel::Name::angle] = 2e-3;
  experiment.noise[Channel::Name::torque] = 0.02;
  std::mt19937 random(seed + 100);
  std::normal_distribution<double> read(0, 0.02);
  double shown = 0, last = 0, t = 0;
  for (Reading& one : experiment.runs[0].readings) {
    const double now = stiffness * turning_motion(one.t), dt = one.t - t;
    const double behind = dt > 0 ? (now - last) / dt * lag : 0;
    shown = lag > 0 && dt > 0 ? now - behind + std::exp(-dt / lag) * (shown - last + behind) : now;
    last = now, t = one.t;
    one[column_Fx] = shown + read(random);
  }
  return experiment;
}

}  // namespace

TEST_CASE("noise of what is imposed is no cause, and hides none") {
  std::size_t none = 0, found = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    none += diagnose::diagnose(Study(with_probable_motion(lagging_torque(0, seed)))).cause.verdict ==
            CauseVerdict::none;
    found += diagnose::diagnose(Study(with_probable_motion(lagging_torque(1, seed))))
                 .cause.ranking.front()
                 .cause.label() == "sensor_lag";
  }
  // An alarm in ten and a confusion in ten: more than one of five is a chance of 8 % each.
  CHECK(none >= 4);
  CHECK(found >= 4);
}

TEST_CASE("units of angle and of time change nothing") {
  rc::check([] {
    const double unit = *rc::gen::element(1e-3, 0.1, 50.0), slower = *rc::gen::element(1e-2, 3.0, 1e3);
    const Experiment read = led_joint(turning_motion, angle_noise, *rc::gen::inRange(1U, 100U));
    Experiment other = read;
    other.noise[Channel::Name::angle] *= unit;
    for (Reading& one : other.runs[0].readings) one[column_x] *= unit, one.t *= slower;
    const Experiment moved = with_probable_motion(read), scaled = with_probable_motion(other);
    for (std::size_t i = 0; i <= 60; ++i)
      RC_ASSERT(std::abs(angle_at(scaled, i) - unit * angle_at(moved, i)) < 1e-9 * unit);
  });
}

TEST_CASE("an exact command, and one that another run measures, stay as they are") {
  Experiment exact = led_joint(turning_motion, angle_noise, 3);
  exact.noise[Channel::Name::angle] = 0;
  Experiment mixed = led_joint(turning_motion, angle_noise, 4);
  mixed.runs.push_back(mixed.runs[0]);
  mixed.runs[1].control = Control::force;
  for (const Experiment& one : {exact, mixed}) {
    const Experiment same = with_probable_motion(one);
    CHECK(same.noise[Channel::Name::angle] == one.noise[Channel::Name::angle]);
    for (std::size_t i = 0; i <= 60; ++i) CHECK(angle_at(same, i) == angle_at(one, i));
  }
}
