#include "trial/simulator/joint_law.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "tests/close_to.hpp"

using namespace plumbline::simulator;

namespace {

constexpr double stiffness = 2, dt = 1e-3;

Joint joint() {
  return {.stiffness = stiffness};
}

/// Turned steadily from where it is to there; what it carries beyond MuJoCo's own spring at the end, at rest.
class Turned {
 public:
  explicit Turned(const Joint& joint) : law_(joint, 0.01, 1) {
    law_.remember(0, dt);
    law_.begin_history();
  }
  double to(double deflection, double seconds = 1) {
    const int steps = static_cast<int>(std::lround(seconds / dt));
    const double from = at_;
    for (int s = 1; s <= steps; ++s) {
      at_ = from + (deflection - from) * s / steps;
      law_.remember(at_, dt);
    }
    return law_.torque(at_, 0);
  }
  double wait(double seconds) { return to(at_, seconds); }

 private:
  JointLaw law_;
  double at_ = 0;
};

}  // namespace

TEST_CASE("a plain joint adds nothing to its spring") {
  CHECK(Turned(joint()).to(0.3) == 0);
}

TEST_CASE("sliders: stiff before they slip, and Masing's rule") {
  Joint one = joint();
  one.slider = {{0.5, 0.06}, {0.25, 0.1}};  // yield at 0.06 and 0.2 rad
  Turned turned(one);
  CHECK(turned.to(0.04) == close_to(-(0.5 + 0.25) * stiffness * 0.04));
  const double there = turned.to(0.1);
  CHECK(there == close_to(-(0.06 + 0.25 * stiffness * 0.1)));
  // from a reversal at 0.1 by 2 u the torque changes by twice what it was at u from rest
  CHECK(turned.to(0.1 - 2 * 0.04) - there == close_to(2 * (0.5 + 0.25) * stiffness * 0.04));
  CHECK(turned.to(0.4) == close_to(-(0.06 + 0.1)));
}

TEST_CASE("a stiff slider is dry friction against the direction of motion") {
  Joint one = joint();
  one.slider = {{100, 0.05}};
  Joint dry = joint();
  dry.friction.torque = 0.05;
  Turned slides(one), rubs(dry);
  CHECK(slides.to(0.3) == close_to(-0.05));
  CHECK(rubs.to(0.3) == close_to(-0.05));
  CHECK(slides.to(0.2) == close_to(0.05));
  CHECK(rubs.to(0.2) == close_to(0.05));
}

TEST_CASE("friction that depends on load, direction, angle and speed") {
  const auto carried = [](const Friction& friction, double there, double seconds = 1) {
    Joint one = joint();
    one.friction = friction;
    return std::abs(Turned(one).to(there, seconds));
  };
  CHECK(carried({.torque = 0.05, .growth = 4}, 0.5) == close_to(0.05 * 3));
  CHECK(carried({.torque = 0.05, .uneven = 0.6}, 0.5) == close_to(0.05 * 1.6));
  CHECK(carried({.torque = 0.05, .uneven = 0.6}, -0.5) == close_to(0.05 * 0.4));
  CHECK(carried({.torque = 0.05, .ripple = 0.5, .waves = 3}, 0.4) ==
        close_to(0.05 * (1 + 0.5 * std::sin(1.2))));
  const Friction falls{.torque = 0.05, .fall = 2, .speed = 0.01};
  CHECK(carried(falls, 0.001, 5) > 0.13);  // slow: nearly (1 + fall) times
  CHECK(carried(falls, 2, 5) < 0.051);     // fast
}

TEST_CASE("an asymmetric spring, play, hardening, a stop and a piecewise spring") {
  Joint uneven = joint();
  uneven.asymmetry = -0.1;
  CHECK(Turned(uneven).to(0.2) == close_to(-stiffness * 0.9 * 0.2));
  CHECK(Turned(uneven).to(-0.2) == close_to(stiffness * 1.1 * 0.2));
  Joint loose = joint();
  loose.backlash = 0.05, loose.hardening = 2;
  CHECK(Turned(loose).to(0.04) == 0);
  CHECK(Turned(loose).to(0.25) == close_to(-stiffness * 0.2 * (1 + 2 * 0.04)));
  Joint stopped = joint();
  stopped.stop = 0.1, stopped.stop_stiffness = 7;
  CHECK(Turned(stopped).to(-0.3) == close_to(7 * 0.2));
  Joint soft = joint();
  soft.knee = 0.1, soft.give = 0.4;
  CHECK(Turned(soft).to(0.1) == 0);
  CHECK(Turned(soft).to(-0.3) == close_to(-stiffness * 0.4 * 0.2));
  soft.backlash = 0.05, soft.asymmetry = 0.2;
  CHECK(Turned(soft).to(0.3) == close_to(-stiffness * 1.2 * (0.25 - 0.4 * 0.15)));
}

TEST_CASE(
    "plastic set: elastic up to yield, softer beyond, elastic unloading, yield at the earlier maximum") {
  Joint one = joint();
  one.yield = 0.2, one.flow = 0.5;  // yields at 0.1 rad; then stiffness / 1.5
  Turned turned(one);
  CHECK(turned.to(0.08) == close_to(-0.16));
  const double top = 0.2 + stiffness / 1.5 * 0.1;
  CHECK(turned.to(0.2) == close_to(-top).epsilon(1e-3));
  const double set = 0.2 - top / stiffness;
  CHECK(turned.to(0.1) == close_to(-stiffness * (0.1 - set)).epsilon(1e-3));
  CHECK(turned.to(0.2) == close_to(-top).epsilon(1e-3));
}

TEST_CASE("two Maxwell arms relax, each with its time constant") {
  Joint one = joint();
  one.arm = {{0.3, 0.5}, {0.2, 20}};
  Turned turned(one);
  // carried at the end of a turn in 10 ms: all but 1 % of the faster
  CHECK(turned.to(0.1, 0.01) == close_to(-0.5 * stiffness * 0.1).epsilon(0.01));
  CHECK(turned.wait(2) ==
        close_to(-stiffness * 0.1 * (0.3 * std::exp(-4) + 0.2 * std::exp(-0.1))).epsilon(0.01));
}

TEST_CASE("ageing springs soften with the logarithm of time, or towards a limit") {
  Joint creeps = joint();
  creeps.ageing.creep = 0.1, creeps.ageing.start = 0.5;
  CHECK(Turned(creeps).to(0.2, 4) == close_to(-stiffness * 0.2 / (1 + 0.1 * std::log(9))).epsilon(1e-3));
  Joint warms = joint();
  warms.ageing.loss = 0.2, warms.ageing.warming = 3;
  CHECK(Turned(warms).to(0.2, 4) ==
        close_to(-stiffness * 0.2 * (1 - 0.2 * (1 - std::exp(-4.0 / 3)))).epsilon(1e-3));
}
