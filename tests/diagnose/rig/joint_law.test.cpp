#include "diagnose/rig/joint_law.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A spring of 2 N m/rad at rest at 0.1, and nothing else but what a test adds.
JointLaw spring() {
  JointLaw law;
  law.stiffness = 2;
  law.rest = 0.1;
  return law;
}

/// Both sides of a law, and its slope against a difference quotient.
void check_torque(const JointLaw& law, double deflection, double expected) {
  CAPTURE(deflection);
  for (const double side : {1.0, -1.0}) {
    const double angle = law.rest + side * deflection;
    CHECK(law.elastic(angle).value == close_to(side * expected));
    constexpr double step = 1e-6;
    const double quotient = (law.elastic(angle + step).value - law.elastic(angle - step).value) / (2 * step);
    CHECK(law.elastic(angle).slope == close_to(quotient).epsilon(1e-6));
  }
}

}  // namespace

TEST_CASE("a spring, with hardening, play and a stop: torques by hand") {
  JointLaw law = spring();
  check_torque(law, 0.3, 0.6);
  law.hardening = 5;
  check_torque(law, 0.3, 2 * 0.3 * (1 + 5 * 0.09));
  law = spring();
  law.backlash = 0.05;
  check_torque(law, 0.03, 0);
  check_torque(law, 0.3, 2 * 0.25);
  law = spring();
  law.stop = 0.2;
  law.stop_stiffness = 7;
  check_torque(law, 0.15, 0.3);
  check_torque(law, 0.3, 0.6 + 7 * 0.1);
}

TEST_CASE("a piecewise spring: k d up to its threshold, slope k (1 - a) beyond, on both sides") {
  JointLaw law = spring();
  law.knee = 0.2;
  law.give = 0.4;
  check_torque(law, 0.15, 0.3);
  check_torque(law, 0.3, 2 * (0.2 + 0.6 * 0.1));
  CHECK(law.elastic(0.1 + 0.2).value == close_to(0.4));
  CHECK(law.elastic(0.1 + 0.3).energy == close_to(0.09 - 2 * 0.4 * 0.01 / 2));
  law.backlash = 0.05;  // the spring turns behind its play
  check_torque(law, 0.35, 2 * (0.2 + 0.6 * 0.1));
  law.backlash = 0;
  law.asymmetry = 0.25;
  CHECK(law.elastic(0.1 - 0.3).value == close_to(-1.5 * (0.2 + 0.6 * 0.1)));
  const JointLaw plain = spring();
  for (const double d : {-0.3, 0.0, 0.1, 0.4}) {
    JointLaw nothing = spring(), far = spring();
    nothing.knee = 0.2;
    far.knee = 0.5, far.give = 0.4;
    CHECK(nothing.elastic(0.1 + d).value == plain.elastic(0.1 + d).value);
    CHECK(far.elastic(0.1 + d).value == plain.elastic(0.1 + d).value);
  }
}

TEST_CASE("a dry contact sticks up to its slip torque, and after each reversal") {
  const JointLaw law = spring();
  const JointSlider dry{JointLaw::sticking * 2, 0.4, 0};
  const JointMemory last{.angle = 0.2};
  const auto torque = [&](double angle, Contact contact) { return law.dry(dry, 0.1, angle, last, contact); };
  CHECK(torque(0.2, Contact::sticks).value == close_to(0.1));
  CHECK(torque(0.2 + 1e-7, Contact::sticks).value == close_to(0.1 + dry.stiffness * 1e-7));
  CHECK(torque(0.2, Contact::sticks).slope == dry.stiffness);
  CHECK(torque(0.9, Contact::slips_up).value == 0.4);
  CHECK(torque(0.9, Contact::slips_down).value == -0.4);
  CHECK(torque(0.9, Contact::slips_up).slope == 0);
  CHECK(law.dry({2, 0, 0}, 0, 0.9, last, Contact::slips_up).value == 0);

  const auto next = [&](double angle, Contact contact) { return law.next(dry, 0.1, angle, last, contact); };
  CHECK(next(0.2, Contact::sticks) == Contact::sticks);
  CHECK(next(0.3, Contact::sticks) == Contact::slips_up);
  CHECK(next(0.1, Contact::sticks) == Contact::slips_down);
  CHECK(next(0.3, Contact::slips_up) == Contact::slips_up);
  CHECK(next(0.1, Contact::slips_up) == Contact::sticks);
  CHECK(next(0.1, Contact::slips_down) == Contact::slips_down);
  CHECK(next(0.3, Contact::slips_down) == Contact::sticks);
}

TEST_CASE("load-dependent friction slips at tau (1 + growth |d|); its torque is the derivative of its work") {
  const JointLaw law = spring();
  const JointSlider grows{2e5, 0.4, 0.8};
  const JointMemory last{.angle = -0.1};
  for (const double angle : {0.5, -0.4}) {
    for (const auto& [contact, sign] :
         {std::pair(Contact::slips_up, 1.0), std::pair(Contact::slips_down, -1.0)}) {
      const auto at = [&](double q) { return law.dry(grows, 0, q, last, contact); };
      CHECK(at(angle).value == close_to(sign * (0.4 + 0.8 * std::abs(angle - 0.1))));
      const double step = 1e-5;
      CHECK((at(angle + step).energy - at(angle - step).energy) / (2 * step) ==
            close_to(at(angle).value).epsilon(1e-7));
      CHECK((at(angle + step).value - at(angle - step).value) / (2 * step) ==
            close_to(at(angle).slope).epsilon(1e-7));
    }
  }
}

TEST_CASE("a contact with a profile carries its fraction; its torque is the derivative of its work") {
  const JointLaw law = spring();
  const std::vector<FreeLaw::Knot> knots{{-0.3, 0.6}, {0, 0.2}, {0.2, 0.8}};
  const JointSlider contact{5, 1, {}, false, true, TorqueTable(knots)};
  const JointMemory last{.angle = 0.05};  // d = -0.05
  const auto at = [&](double d, Contact state) { return law.dry(contact, 0.1, law.rest + d, last, state); };
  CHECK(at(0.1, Contact::sticks).value == close_to((0.1 + 5 * 0.15) * 0.5));
  CHECK(at(0.1, Contact::slips_up).value == close_to(0.5));
  CHECK(at(-0.15, Contact::slips_down).value == close_to(-0.4));
  CHECK(law.next(contact, 0.1, law.rest + 0.1, last, Contact::sticks) == Contact::sticks);
  CHECK(law.next(contact, 0.1, law.rest + 0.2, last, Contact::sticks) == Contact::slips_up);  // 0.1 + 1.25
  // From d = -0.05 to 0.1 all of it, in two trapezia.
  CHECK(at(0.1, Contact::slips_up).energy == close_to(0.05 * (0.2 + 0.4 / 0.3 * 0.025) + 0.1 * 0.35));
  // Differences of a cubic: the step squared, and rounding of 1e-16 over the step.
  constexpr double step = 1e-5;
  for (const double d : {-0.2, -0.02, 0.13})
    for (const Contact state : {Contact::sticks, Contact::slips_up, Contact::slips_down}) {
      CHECK((at(d + step, state).energy - at(d - step, state).energy) / (2 * step) ==
            close_to(at(d, state).value).epsilon(1e-8));
      CHECK((at(d + step, state).value - at(d - step, state).value) / (2 * step) ==
            close_to(at(d, state).slope).epsilon(1e-8));
    }
}

TEST_CASE("an asymmetric spring") {
  JointLaw law = spring();
  law.asymmetry = 0.2;
  CHECK(law.elastic(0.1 + 0.3).value == close_to(2 * 1.2 * 0.3));
  CHECK(law.elastic(0.1 - 0.3).value == close_to(-2 * 0.8 * 0.3));
  CHECK(law.elastic(0.1 - 0.3).slope == close_to(1.6));
  CHECK(law.elastic(0.1 - 0.3).energy == close_to(1.6 * 0.3 * 0.3 / 2));
}

TEST_CASE(
    "a yielding spring: k / (1 + slope) beyond yield, unloading at k, yielding again where it reversed") {
  JointLaw law = spring();
  law.yield = 0.5;
  law.flow = 0.25;
  JointMemory memory;
  CHECK(law.elastic(0.1 + 0.2, memory).value == close_to(0.4));
  // 0.2 N m in excess at d = 0.35: 0.5 + 0.2 / 1.25, and the work 0.5^2 / 2 k + (0.5 + 0.66) / 2 x 0.1.
  const Torque beyond = law.elastic(0.1 + 0.35, memory);
  CHECK(beyond.value == close_to(0.66));
  CHECK(beyond.slope == close_to(2 / 1.25));
  CHECK(beyond.energy == close_to(0.0625 + 0.058));
  law.flow_to(0.1 + 0.35, memory);
  CHECK(memory.carried == close_to(0.66));
  CHECK(memory.set ==
        close_to(0.25 * 0.2 / 1.25 / 2));  // slope times what is in excess of the yield now, over k
  CHECK(law.elastic(0.1 + 0.35, memory).value == close_to(0.66));
  CHECK(law.elastic(0.1, memory).value == close_to(-2 * 0.02));
  CHECK(law.elastic(0.1 + 0.35 + 0.1, memory).value == close_to(0.66 + 0.2 / 1.25));
}

TEST_CASE("a Maxwell arm relaxes and takes up the joint's rotation") {
  JointLaw law = spring();
  law.arm_stiffness[1] = 3;
  JointMemory last{.angle = 0.2};
  last.arm[1] = 0.5;
  CHECK(law.viscous(1, 0.2, last, 0.25, 0.9).value == close_to(0.25 * 0.5));
  CHECK(law.viscous(1, 0.3, last, 0.25, 0.9).value == close_to(0.125 + 3 * 0.9 * 0.1));
  CHECK(law.viscous(1, 0.3, last, 0.25, 0.9).slope == close_to(2.7));
}
