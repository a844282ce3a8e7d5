#include "diagnose/motion/drive.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/close_to.hpp"

namespace plumbline::motion {
namespace {

/// A pendulum whose drive is off.
Imposed<double> pendulum(double inertia, double gravity) {
  return {0, 1, 1, false, inertia, gravity};
}

double energy(const Imposed<double>& now, const Motion<double>& state) {
  return now.inertia * state.v * state.v / 2 - now.gravity * std::cos(state.q);
}

}  // namespace

TEST_CASE("a derivative is that of the formula") {
  const auto x = Dual<1>::variable(0.7, 0);
  const Dual<1> y = sin(x) * exp(-x) / (1 + x * x) + abs(x - 1);
  const double s = std::sin(0.7), c = std::cos(0.7), e = std::exp(-0.7), d = 1 + 0.49;
  CHECK(y.value == close_to(s * e / d + 0.3));
  CHECK(y.derivative(0) == close_to((c - s) * e / d - s * e * 1.4 / (d * d) - 1));
}

TEST_CASE("a free pendulum keeps its energy, by the square of the step") {
  const Imposed<double> now = pendulum(0.02, 1.3);
  const auto drift = [&](double h) {
    Motion<double> state{1.2, 0};
    double most = 0;
    for (int k = 0; k * h < 2; ++k) {
      state = after(Drive<double>(), now, state, h);
      most = std::max(most, std::abs(energy(now, state) - energy(now, {1.2, 0})));
    }
    return most;
  };
  // Second order: a step of a half leaves a quarter; the next order changes that by less than a tenth here.
  CHECK(drift(0.001) / drift(0.002) == doctest::Approx(0.25).epsilon(0.1));
}

TEST_CASE("dry friction stops a wheel after I v / tau, and holds it to the last bit") {
  Drive<double> drive;
  drive[Term::dry] = 0.05;
  const Imposed<double> now = pendulum(0.02, 0);
  constexpr double h = 0.001, v = 1;
  Motion<double> state{0, v};
  int steps = 0;
  for (; state.v != 0 && steps < 10000; ++steps) state = after(drive, now, state, h);
  CHECK(steps * h == doctest::Approx(now.inertia * v / 0.05).epsilon(2 * h / 0.4));  // to a step
  // v^2 I / (2 tau), but for the step in which it stops: h v of that step, below h^2 tau / I.
  CHECK(state.q == doctest::Approx(now.inertia * v * v / 0.1).epsilon(h));
  const double held = state.q;
  for (int k = 0; k < 100; ++k) state = after(drive, now, state, h);
  CHECK(state.q == held);
}

TEST_CASE("a gear that loses c drives with 1 - c of the torque, and holds against a load that it blocks") {
  Drive<double> drive;
  drive[Term::stall_torque] = 1, drive[Term::loss_driving] = 0.3, drive[Term::loss_driven] = 0.3;
  // No rotor: all of the motor's torque passes the gear.
  Imposed<double> now{10, 1, 2, true, 0.02, 0};  // error far beyond the duty limit: 2 N m
  const Motion<double> driven = after(drive, now, {0, 0}, 1e-3);
  CHECK(driven.v == close_to(1e-3 * 2 * 0.7 / 0.02));
  // A load that drives the gear backwards passes its weight through it: with a rotor alone there is no loss
  // where nothing passes.
  drive[Term::armature] = 0.02;
  now.inertia = 0.02, now.powered = false, now.gravity = 1;
  const Motion<double> falling = after(drive, now, {std::numbers::pi / 2, 0}, 1e-3);
  // The rotor's half of the weight passes: 1 - 0.3 / 2 of it accelerates both.
  CHECK(falling.v == close_to(-1e-3 * (1 - 0.15) / 0.04));
}

TEST_CASE("terminal speed is torque over damping") {
  Drive<double> drive;
  drive[Term::stall_torque] = 0.5, drive[Term::back_emf] = 0.2, drive[Term::viscous] = 0.05;
  const Imposed<double> now{1e6, 1, 3, true, 0.01, 0};
  Motion<double> state{0, 0};
  for (int k = 0; k < 2000; ++k) state = after(drive, now, state, 0.001);  // 50 time constants
  CHECK(state.v == close_to(0.5 * 3 / 0.25));
}

}  // namespace plumbline::motion
