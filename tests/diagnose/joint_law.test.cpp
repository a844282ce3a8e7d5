#include "diagnose/model/joint_law.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A spring of 2 N m/rad at rest at 0.1, and nothing else but what a test adds.
JointLaw spring() {
  return {.stiffness = 2,
          .rest = 0.1,
          .backlash = 0,
          .stop = 10,
          .stop_stiffness = 0,
          .hardening = 0,
          .friction = 0,
          .arm_stiffness = 0};
}

/// Both sides of a law, and its slope against a difference quotient.
void check_torque(const JointLaw& law, double deflection, double expected) {
  CAPTURE(deflection);
  for (const double side : {1.0, -1.0}) {
    const double angle = law.rest + side * deflection;
    CHECK(law.elastic(angle).value == doctest::Approx(side * expected));
    constexpr double step = 1e-6;
    const double quotient = (law.elastic(angle + step).value - law.elastic(angle - step).value) / (2 * step);
    CHECK(law.elastic(angle).slope == doctest::Approx(quotient).epsilon(1e-6));
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

TEST_CASE("a dry contact carries its torque until it slips, and turns back through sticking") {
  JointLaw law = spring();
  law.friction = 0.4;
  const JointMemory last{.angle = 0.2, .friction = 0.1};
  const double stiff = JointLaw::sticking * 2;
  CHECK(law.dry(0.2, last, Contact::sticks).value == doctest::Approx(0.1));
  CHECK(law.dry(0.2 + 1e-7, last, Contact::sticks).value == doctest::Approx(0.1 + stiff * 1e-7));
  CHECK(law.dry(0.2, last, Contact::sticks).slope == stiff);
  CHECK(law.dry(0.9, last, Contact::slips_up).value == 0.4);
  CHECK(law.dry(0.9, last, Contact::slips_down).value == -0.4);
  CHECK(law.dry(0.9, last, Contact::slips_up).slope == 0);
  CHECK(spring().dry(0.9, last, Contact::slips_up).value == 0);

  CHECK(law.next(0.2, last, Contact::sticks) == Contact::sticks);
  CHECK(law.next(0.3, last, Contact::sticks) == Contact::slips_up);
  CHECK(law.next(0.1, last, Contact::sticks) == Contact::slips_down);
  CHECK(law.next(0.3, last, Contact::slips_up) == Contact::slips_up);
  CHECK(law.next(0.1, last, Contact::slips_up) == Contact::sticks);
  CHECK(law.next(0.1, last, Contact::slips_down) == Contact::slips_down);
  CHECK(law.next(0.3, last, Contact::slips_down) == Contact::sticks);
}

TEST_CASE("a Maxwell arm forgets what it carried and takes what the joint turns") {
  JointLaw law = spring();
  law.arm_stiffness = 3;
  const JointMemory last{.angle = 0.2, .arm = 0.5};
  CHECK(law.viscous(0.2, last, 0.25, 0.9).value == doctest::Approx(0.25 * 0.5));
  CHECK(law.viscous(0.3, last, 0.25, 0.9).value == doctest::Approx(0.125 + 3 * 0.9 * 0.1));
  CHECK(law.viscous(0.3, last, 0.25, 0.9).slope == doctest::Approx(2.7));
}
