#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "diagnose/motion/roll_out.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

std::vector<double> followed(const Drive<double>& drive, const MotionLog& log) {
  return angles_of(drive, log, {0, 0, log.time.size()}, log.position.front(), 0.0);
}

/// A log of a command that stays, long enough for every transient to die.
MotionLog held(double command, double gain, const Drive<double>& drive) {
  MotionLog log = test_log(drive, gain, 0);
  std::fill(log.command.begin(), log.command.end(), command);
  log.position.front() = 0;
  return log;
}

Drive<double> frictionless() {
  Drive<double> drive = planted_drive(Term::command_delay, 0);
  drive[Term::dry] = 0, drive[Term::zero] = 0;
  return drive;
}

}  // namespace

TEST_CASE("a derivative part is viscous friction of stall torque times supply, while the duty has no limit") {
  constexpr double gain_of_speed = 0.02;
  MotionLog log = test_log(planted_drive(Term::command_delay, 0), 4, 0);
  for (double& one : log.command) one *= 0.5;  // duty below one
  Drive<double> derivative = planted_drive(Term::derivative_gain, gain_of_speed),
                viscous = planted_drive(Term::viscous, 0.3 * 12 * gain_of_speed);
  const std::vector<double> a = followed(derivative, log), b = followed(viscous, log);
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  // Both are of second order: steps of 2 ms beside a time constant of 13 ms kg m^2 / 0.32 N m s = 41 ms, on a
  // motion of 0.4 rad whose friction turns it within a step: (2/41)^2 / 12 of it, 0.1 mrad.
  CHECK(most < 1e-4);
  CHECK(std::abs(a[100] - followed(planted_drive(Term::command_delay, 0), log)[100]) > 1e-3);
}

TEST_CASE(
    "an integral part leaves no error under a weight, and a proportional one the weight over the gain") {
  constexpr double command = 0.5, gain = 16;
  const MotionLog log = held(command, gain, frictionless());
  Drive<double> drive = frictionless();
  const double plain = followed(drive, log).back();
  CHECK(0.16 * gain * 0.3 * 12 * (command - plain) == doctest::Approx(0.59 * std::sin(plain)).epsilon(1e-6));
  drive[Term::integral_gain] = 0.16 * gain * 4;
  // The slowest pole is near -4 1/s: e^(-16) of 0.03 rad after 4 s.
  CHECK(std::abs(followed(drive, log).back() - command) < 1e-6);
}

TEST_CASE("an integral part keeps no more than the whole duty") {
  Drive<double> drive;
  drive[Term::integral_gain] = 5;
  CHECK(integrated<double>(drive, 0.9, 1, 0.1) == 1);
  CHECK(integrated<double>(drive, 0.0, -1, 0.1) == -0.5);
}

TEST_CASE("a log that is cut in two has the integral part of its whole at the cut") {
  Drive<double> drive = planted_drive(Term::integral_gain, 4);
  MotionLog log = test_log(drive, 4, 0);
  const Segment behind{0, 200, 400};
  const InitialState at = initial_state(log, 200);
  const std::vector<double> rest = angles_of(drive, log, behind, log.position[200], at.v);
  // The speed at the cut is a parabola's over 60 ms: off by its third derivative, 25 rad/s^3, times 3e-4 s^2,
  // 8 mrad/s, for the 0.1 s in which the servo forgets it; the integral of read errors by less.
  for (std::size_t k = 0; k < rest.size(); ++k) CHECK(std::abs(rest[k] - log.position[200 + k]) < 1e-3);
}

TEST_CASE("a feed-forward of the whole weight leaves no error at rest") {
  Drive<double> drive = frictionless();
  drive[Term::gravity_forward] = 1;
  CHECK(followed(drive, held(0.5, 8, frictionless())).back() == doctest::Approx(0.5).epsilon(1e-6));
}

TEST_CASE(
    "a torque that depends on the angle keeps the energy with its potential, by the square of the step") {
  Drive<double> drive;
  drive[Term::periods] = 24, drive[Term::cogging_sine] = 0.2, drive[Term::cogging_cosine] = -0.1;
  drive[Term::contact_above] = 3, drive[Term::above_from] = 0.4;
  drive[Term::contact_below] = 5, drive[Term::below_from] = -0.3;
  const Imposed<double> now{0, 1, 1, false, 0.02, 1.3};
  const auto energy = [&](const Motion<double>& s) {
    const double above = std::max(0.0, s.q - 0.4), below = std::min(0.0, s.q + 0.3);
    return 0.02 * s.v * s.v / 2 - 1.3 * std::cos(s.q) +
           (0.2 * std::cos(24 * s.q) + 0.1 * std::sin(24 * s.q)) / 24 + 1.5 * above * above +
           2.5 * below * below;
  };
  const auto drift = [&](double h) {
    Motion<double> state{0.9, 0};
    const double begin = energy(state);
    double most = 0;
    for (int k = 0; k * h < 2; ++k) {
      state = after(drive, now, state, h);
      most = std::max(most, std::abs(energy(state) - begin));
    }
    return most;
  };
  // Second order: half the step leaves a quarter; kinks of the contacts are met within a step, of third
  // order.
  CHECK(drift(1e-4) / drift(2e-4) == doctest::Approx(0.25).epsilon(0.15));
}

TEST_CASE("a motor whose torque ripples balances a weight by the torque at its angle") {
  Drive<double> drive = frictionless();
  drive[Term::periods] = 7, drive[Term::ripple_sine] = 0.2, drive[Term::ripple_cosine] = 0.1;
  const double at = followed(drive, held(0.5, 8, frictionless())).back();
  const double factor = 1 + 0.2 * std::sin(7 * at) + 0.1 * std::cos(7 * at);
  CHECK(0.16 * 8 * 0.3 * 12 * (0.5 - at) * factor == doctest::Approx(0.59 * std::sin(at)).epsilon(1e-6));
}

TEST_CASE("friction grows with temperature, dry and viscous") {
  Drive<double> cold, warm;
  cold[Term::dry] = 0.05, cold[Term::viscous] = 0.02;
  warm = cold;
  warm[Term::friction_warming] = -0.02;
  cold[Term::dry] *= 0.8, cold[Term::viscous] *= 0.8;
  Imposed<double> now{0, 1, 1, false, 0.02, 0};
  now.warmer = 10;
  Motion<double> a{0, 1}, b{0, 1};
  for (int k = 0; k < 100; ++k) a = after(cold, now, a, 1e-3), b = after(warm, now, b, 1e-3);
  CHECK(a.q == close_to(b.q));
}

TEST_CASE("a pendulum on a base that accelerates hangs where gravity and acceleration add up") {
  Drive<double> drive;
  drive[Term::viscous] = 0.3, drive[Term::base_motion] = 1;
  Imposed<double> now{0, 1, 1, false, 0.02, 1.3};
  now.base_acceleration = 2;
  Motion<double> state{0, 0};
  for (int k = 0; k < 20000; ++k) state = after(drive, now, state, 1e-3);
  CHECK(state.q == doctest::Approx(-std::atan2(2, 9.81)).epsilon(1e-9));
}

}  // namespace plumbline::motion
