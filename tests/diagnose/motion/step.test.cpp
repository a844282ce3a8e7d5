#include "diagnose/motion/step.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

constexpr double rotor = 0.006, load = 0.02;

/// A free rotor and a free wheel, with a gear of this kind between them.
Drive<double> free_gear(Term term, double value) {
  Drive<double> drive;
  drive[Term::armature] = rotor, drive[term] = value;
  return drive;
}

Imposed<double> free_wheel() {
  return {0, 1, 1, false, load, 0};
}

double momentum(const Motion<double>& state) {
  return load * state.v + rotor * (state.v + state.twisting);
}

}  // namespace

TEST_CASE("what slides to rest, or turns, under a constant torque does so where Coulomb's law has it") {
  constexpr double friction = 0.05, h = 0.01, begin = 1.237;
  for (const double torque : {0.0, -0.03, -0.08}) {  // the last one is more than friction holds
    CAPTURE(torque);
    Drive<double> drive = free_gear(Term::torque_offset, torque);
    drive[Term::dry] = friction;
    Motion<double> state{0, begin};
    constexpr int steps = 100;
    for (int k = 0; k < steps; ++k) state = after(drive, free_wheel(), state, h);
    const double slower = (friction - torque) / (rotor + load), back = (friction + torque) / (rotor + load),
                 stops = begin / slower;
    const double since = back < 0 ? steps * h - stops : 0;
    // Exact but for rounding: the torque is constant, and the step begins anew where the speed ends.
    CHECK(state.q == close_to(begin * begin / (2 * slower) + back * since * since / 2));
    CHECK(state.v == close_to(back * since));
  }
}

TEST_CASE("an elastic gear swings by its stiffness and both inertias") {
  constexpr double compliance = 0.05, h = 2e-4;
  const Drive<double> drive = free_gear(Term::gear_compliance, compliance);
  Motion<double> state{0, 0};
  state.twist = 0.01;
  int sign_changes = 0;
  double last = 0;
  for (int k = 1; k < 20000; ++k) {
    const double before = state.twist;
    state = after(drive, free_wheel(), state, h);
    if (before * state.twist < 0) ++sign_changes, last = k * h;
    CHECK(std::abs(momentum(state)) < 1e-12);
  }
  const double together = rotor * load / (rotor + load),
               half_period = std::numbers::pi * std::sqrt(together * compliance);
  // The first crossing is a quarter of a period after the begin; compliance that is not resolved adds
  // h^2 / 100 / together = 1e-7, the step its square, and a crossing is known to h.
  CHECK(last / (sign_changes - 0.5) == doctest::Approx(half_period).epsilon(1e-3));
}

TEST_CASE("a gear with play meets its other side once, and both go on together with the momentum") {
  constexpr double play = 0.05, h = 1e-3;
  const Drive<double> drive = free_gear(Term::play, play);
  Motion<double> state{0, 0};
  state.twist = -play / 2, state.twisting = 2;  // the rotor goes ahead at 2 rad/s
  const double before = momentum(state);
  for (int k = 0; k < 200; ++k) {
    state = after(drive, free_wheel(), state, h);
    CHECK(momentum(state) == close_to(before));
    // Contact is met at the end of a step to a third of the step's own way.
    CHECK(std::abs(state.twist) < play / 2 + 2 * h);
  }
  // Plastic: an impact leaves a hundredth of the relative speed.
  CHECK(std::abs(state.twisting) < 2 * 2.0 / 100);
}

TEST_CASE("a gear that is nearly stiff moves as a drive in one piece") {
  Drive<double> stiff = planted_drive(Term::command_delay, 0);
  stiff[Term::gear_compliance] = 1e-9;
  const MotionLog log = test_log(planted_drive(Term::command_delay, 0), 8, 0);
  const std::vector<double> angles = angles_of(stiff, log, {0, 0, log.time.size()}, 0.0, 0.0);
  // The unresolved compliance, h^2 / 100 / 0.0033 kg m^2 = 1.2e-5 rad/(N m), under 1 N m.
  for (std::size_t k = 0; k < angles.size(); ++k) CHECK(std::abs(angles[k] - log.position[k]) < 3e-4);
}

TEST_CASE("a clock that runs fast is a log by the true clock, stretched") {
  Drive<double> drive = planted_drive(Term::dry_rising, 0.03);
  drive[Term::rising_speed] = 0.5, drive[Term::command_delay] = 0.02, drive[Term::drive_lag] = 0.01;
  drive[Term::drag] = 0.01, drive[Term::command_slowness] = 0.6;
  MotionLog log = test_log(drive, 8, 0);
  const Segment whole{0, 0, log.time.size()};
  const std::vector<double> angles = angles_of(drive, log, whole, 0.0, 0.0);
  for (double& t : log.time) t /= 1.25;
  drive[Term::clock_rate] = 0.25;
  const std::vector<double> stretched = angles_of(drive, log, whole, 0.0, 0.0);
  // 10 ms are five steps of 2 ms, and 8 ms are four of 2 ms: the orders of the step differ.
  for (std::size_t k = 0; k < angles.size(); ++k) CHECK(std::abs(stretched[k] - angles[k]) < 2e-3);
}

TEST_CASE("a servo whose speed is limited follows a far command at that speed") {
  Drive<double> drive = planted_drive(Term::command_slowness, 2);  // 0.5 rad/s
  MotionLog log = test_log(drive, 32, 0);
  log.gravity = 0;
  std::fill(log.command.begin() + 1, log.command.end(), 1e3);
  const std::vector<double> angles = angles_of(drive, log, {0, 0, log.time.size()}, 0.0, 0.0);
  // A ramp that a linear servo follows at a constant distance, after its transient.
  const double speed = (angles[399] - angles[300]) / 0.99;
  CHECK(speed == doctest::Approx(0.5).epsilon(1e-3));
}

}  // namespace plumbline::motion
