#include "diagnose/rig/torque.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/rig/joint_law.hpp"
#include "tests/close_to.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A table of four knots: 1 to 2 over 0.2 rad, down to -1 over 0.3, up to 0.5 over 0.5.
const TorqueTable crooked({{-0.2, 1}, {0, 2}, {0.3, -1}, {0.8, 0.5}});

/// Work of a joint's law from rest, against the trapezoids of its torque: of a torque that is straight from
/// step to step, and so fine that a cubic one is to a share of 1e-7.
template <class Law>
double work_by_steps(const Law& torque, double from, double to) {
  constexpr int steps = 4000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double a = from + (to - from) * i / steps, b = from + (to - from) * (i + 1) / steps;
    sum += (torque(a) + torque(b)) / 2 * (b - a);
  }
  return sum;
}

JointLaw plain_spring() {
  JointLaw law;
  law.stiffness = 2;
  law.rest = 0.1;
  return law;
}

}  // namespace

TEST_CASE("a torque table is piecewise linear, extrapolates, and stores its area") {
  const auto check = [](double d, double value, double slope, double energy) {
    CAPTURE(d);
    const Torque found = crooked.at(d);
    CHECK(found.value == close_to(value));
    CHECK(found.slope == close_to(slope));
    CHECK(found.energy == doctest::Approx(energy).epsilon(1e-12));
  };
  check(-0.2, 1, 5, 0);
  check(-0.1, 1.5, 5, 0.125);
  check(-0.4, 0, 5, -0.1);
  check(0, 2, -10, 0.3);
  check(0.1, 1, -10, 0.45);
  check(0.3, -1, 3, 0.45);
  check(0.6, -0.1, 3, 0.285);
  check(1, 1.1, 3, 0.325 + 0.16);
  const TorqueTable level({{0.3, 2}});
  CHECK(level.at(0.8).value == 2);
  CHECK(level.at(0.8).slope == 0);
  CHECK(level.at(0.8).energy == close_to(1));
}

TEST_CASE("the work of a fraction of a table is that of its parts, in both directions") {
  // half of it over one straight part: 0.5 (1 + 2) / 2 0.2
  CHECK(crooked.work(-0.2, 0, 0.5, 0.5) == close_to(0.15));
  CHECK(crooked.work(0, -0.2, 0.5, 0.5) == close_to(-0.15));
  CHECK(crooked.work(0.1, 0.1, 1, 2) == 0);
  // the share from 0 to 1 over it: 0.2 times the mean of s (1 + s), 1/2 + 1/3
  CHECK(crooked.work(-0.2, 0, 0, 1) == close_to(0.2 * 5 / 6));
  CHECK(crooked.work(0, -0.2, 1, 0) == close_to(-0.2 * 5 / 6));
  // whole, over knots: 0.3 + 0.15 to the third, and no more than that to where it is nothing again
  CHECK(crooked.work(-0.2, 0.3, 1, 1) == close_to(0.45));
  CHECK(crooked.work(-0.3, 0.9, 1, 1) == close_to(crooked.at(0.9).energy - crooked.at(-0.3).energy));
  const auto carried = [](double d) { return crooked.at(d).value * (0.2 + 0.8 * (d + 0.1) / 0.8); };
  // trapezoids of a parabola of curvature 20 err by 20 / 12 h^2 each, 7e-8 in all
  CHECK(crooked.work(-0.1, 0.7, 0.2, 1) == close_to(work_by_steps(carried, -0.1, 0.7)).epsilon(1e-6));
}

TEST_CASE("torques add value, slope and energy") {
  Torque sum{1, 2, 3};
  sum += {10, 20, 30};
  CHECK(sum.value == 11);
  CHECK(sum.slope == 22);
  CHECK(sum.energy == 33);
}

TEST_CASE("the energy of a joint is the work of its torque, with every term of its law") {
  JointLaw law = plain_spring();
  law.hardening = 3;
  law.asymmetry = 0.2;
  law.backlash = 0.05;
  law.stop = 0.3;
  law.stop_stiffness = 7;
  law.knee = 0.1;
  law.give = 0.4;
  law.table.push_back(crooked);
  law.table.emplace_back(std::vector<FreeLaw::Knot>{{0, 0.25}});
  const double at_rest = law.elastic(0.1).energy;
  for (const double d : {-0.5, -0.2, 0.03, 0.2, 0.5}) {
    CAPTURE(d);
    const auto torque = [&](double q) { return law.elastic(q).value; };
    CHECK(law.elastic(0.1 + d).energy - at_rest ==
          close_to(work_by_steps(torque, 0.1, 0.1 + d)).epsilon(2e-6));
    CHECK(law.elastic(0.1 + d).slope ==
          close_to((torque(0.1 + d + 1e-6) - torque(0.1 + d - 1e-6)) / 2e-6).epsilon(1e-6));
  }
  // by hand: 1.2 k of d - b, hardened, 0.4 of it less from 0.1 on, a stop of 7 from 0.3 on, the table, and
  // 1/4
  CHECK(law.elastic(0.6).value ==
        close_to(2.4 * (0.45 * (1 + 3 * 0.45 * 0.45) - 0.4 * 0.35) + 7 * 0.2 + (-1 + 3 * 0.2) + 0.25));
  CHECK(law.elastic(0.1 - 0.5).value ==
        close_to(-1.6 * (0.45 * (1 + 3 * 0.45 * 0.45) - 0.4 * 0.35) - 7 * 0.2 + (1 - 5 * 0.3) + 0.25));
}

TEST_CASE("springs that yielded store their elastic energy") {
  JointLaw law = plain_spring();
  law.yield = 0.5;
  law.flow = 0.25;
  const auto torque = [&](double q, const JointMemory& last) { return law.elastic(q, last).value; };
  // Terms that move with the rest angle store `flow` times the torque of the spring.
  for (const double d : {-0.6, -0.2, 0.2, 0.6}) {
    CAPTURE(d);
    const JointMemory fresh;
    CHECK(law.elastic(0.1 + d, fresh).energy ==
          close_to(work_by_steps([&](double q) { return torque(q, fresh); }, 0.1, 0.1 + d)).epsilon(1e-5));
  }
  JointMemory memory;
  law.flow_to(0.1 - 0.45, memory);  // 0.2 N/m rad beyond -0.25: -0.5 - 0.4 / 1.25
  CHECK(memory.carried == close_to(0.82));
  CHECK(memory.set == close_to(-0.45 + 0.41));
  CHECK(torque(0.1 - 0.45, memory) == close_to(-0.82));
  CHECK(torque(0.1 + 0.1, memory) == close_to(2 * 0.14));
  const JointMemory before = memory;
  law.flow_to(0.1 + 0.36, memory);  // 0.4 from where it rests now: below what it has carried
  CHECK(memory.set == before.set);
  CHECK(memory.carried == before.carried);
  // without flow, or without a spring, nothing moves
  JointLaw rigid = law;
  rigid.flow = 0;
  JointMemory none;
  rigid.flow_to(2, none);
  CHECK(none.set == 0);
  CHECK(rigid.elastic(2).value == close_to(3.8));
  JointLaw slack = law;
  slack.stiffness = 0;
  slack.flow_to(2, none);
  CHECK(none.set == 0);
  CHECK(slack.elastic(2).value == 0);
}

TEST_CASE("the slip torque depends on deflection, direction and speed") {
  JointSlider slider;
  slider.yield = 0.4;
  CHECK(slider.acts());
  CHECK(slider.slip(0.7, 1, 3) == 0.4);
  slider.law = {0.8, 0.25, 0.5, 2};
  CHECK(slider.slip(-0.5, 1, 0) == close_to((0.4 + 0.4) * 1.25 * 1.5));
  CHECK(slider.slip(0.5, -1, 0) == close_to(0.8 * 0.75 * 1.5));
  CHECK(slider.slip(0.5, 1, 2) == close_to(0.8 * 1.25 * (1 + 0.5 * std::exp(-1.0))));
  slider.yield = 0;
  CHECK(slider.acts());
  slider.law.growth = 0;
  CHECK_FALSE(slider.acts());
  CHECK(slider.way(0.3) == 0.3);
  CHECK(slider.lever(0.3) == 1);
  slider.widens = true;
  CHECK(slider.way(-0.4) == close_to(0.08));
  CHECK(slider.lever(-0.4) == -0.4);
}

TEST_CASE(
    "a slipping slider does the work of its torque since the last reading, also across its rest angle") {
  const JointLaw law = plain_spring();
  JointSlider slider;
  slider.stiffness = 50;
  slider.yield = 0.4;
  slider.law = {0.8, 0.25, 0.5, 2};
  JointMemory last;
  last.angle = 0.05;  // 0.05 below rest
  last.speed = 1;
  for (const Contact contact : {Contact::sticks, Contact::slips_up, Contact::slips_down})
    for (const double angle : {0.4, 0.07, -0.3}) {
      CAPTURE(angle);
      const auto torque = [&](double q) { return law.along(slider, 0.1, q, last, contact).value; };
      CHECK(law.along(slider, 0.1, angle, last, contact).energy ==
            close_to(work_by_steps(torque, 0.05, angle)).epsilon(1e-5));
    }
  CHECK(law.along(slider, 0.1, 0.07, last, Contact::sticks).value == close_to(0.1 + 50 * 0.02));
  CHECK(law.along(slider, 0.1, 0.07, last, Contact::sticks).slope == 50);
  const double moving = 1 + 0.5 * std::exp(-0.5);
  CHECK(law.along(slider, 0.1, 0.4, last, Contact::slips_up).value == close_to(0.64 * 1.25 * moving));
  CHECK(law.along(slider, 0.1, 0.4, last, Contact::slips_up).slope == close_to(0.8 * 1.25 * moving));
  CHECK(law.along(slider, 0.1, -0.3, last, Contact::slips_up).slope == close_to(-0.8 * 1.25 * moving));
  CHECK(law.along(slider, 0.1, -0.3, last, Contact::slips_down).value == close_to(-0.72 * 0.75 * moving));
  const Torque none = law.along(JointSlider{}, 0.1, 0.4, last, Contact::sticks);
  CHECK((none.value == 0 && none.slope == 0 && none.energy == 0));
}

TEST_CASE("a contact slips where its trial torque exceeds the limit by more than rounding") {
  const JointLaw law = plain_spring();
  JointSlider slider;
  slider.stiffness = 10;
  slider.yield = 0.4;
  JointMemory last;
  last.angle = 0.1;
  const auto next = [&](double trial, Contact contact) {
    return law.next(slider, 0.1, 0.1 + (trial - 0.1) / 10, last, contact);
  };
  // a share of 1e-7 of the torque that it slips at
  for (const double side : {1.0, -1.0}) {
    const Contact slips = side > 0 ? Contact::slips_up : Contact::slips_down;
    CHECK(next(side * 0.4 * (1 + 2e-7), Contact::sticks) == slips);
    CHECK(next(side * 0.4 * (1 + 0.5e-7), Contact::sticks) == Contact::sticks);
    CHECK(next(side * 0.4 * (1 - 0.5e-7), slips) == slips);
    CHECK(next(side * 0.4 * (1 - 2e-7), slips) == Contact::sticks);
  }
  slider.widens = true;  // along d^2/2: from 0 to 0.2^2/2
  CHECK(law.next(slider, 0.25, 0.3, last, Contact::sticks) == Contact::slips_up);
  CHECK(law.next(slider, 0.15, 0.3, last, Contact::sticks) == Contact::sticks);
}

TEST_CASE("a load-dependent slider does the work of its torque") {
  const JointLaw law = plain_spring();
  JointSlider slider;
  slider.stiffness = 50;
  slider.yield = 0.4;
  slider.widens = true;
  JointMemory last;
  last.angle = 0.3;
  for (const Contact contact : {Contact::sticks, Contact::slips_up}) {
    const auto torque = [&](double q) { return law.dry(slider, 0.1, q, last, contact).value; };
    const Torque found = law.dry(slider, 0.1, 0.5, last, contact);
    CHECK(found.energy == close_to(work_by_steps(torque, 0.3, 0.5)).epsilon(1e-6));
    CHECK(found.slope == close_to((torque(0.5 + 1e-6) - torque(0.5 - 1e-6)) / 2e-6).epsilon(1e-6));
  }
  // 0.1 and a spring of 50 along (0.4^2 - 0.2^2) / 2, by a lever of 0.4
  CHECK(law.dry(slider, 0.1, 0.5, last, Contact::sticks).value == close_to((0.1 + 50 * 0.06) * 0.4));
  CHECK(law.dry(slider, 0.1, 0.5, last, Contact::slips_down).value == close_to(-0.4 * 0.4));
}

TEST_CASE("a Maxwell arm stores its earlier torque and the joint's rotation") {
  JointLaw law = plain_spring();
  law.arm_stiffness[2] = 3;
  JointMemory last;
  last.angle = 0.2;
  last.arm[2] = 0.5;
  const auto torque = [&](double q) { return law.viscous(2, q, last, 0.25, 0.9).value; };
  CHECK(law.viscous(2, 0.5, last, 0.25, 0.9).energy ==
        close_to(work_by_steps(torque, 0.2, 0.5)).epsilon(1e-9));
  CHECK(law.viscous(2, 0.5, last, 0.25, 0.9).slope == close_to(2.7));
}
