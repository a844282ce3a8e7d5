#include "diagnose/motion/phases.hpp"

#include <doctest/doctest.h>

#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {

TEST_CASE("every reading is of one phase, and the phases' errors sum to the logs'") {
  const Drive<double> before = planted_drive(Term::dry, 0), after = planted_drive(Term::dry, 0.03);
  MotionLog log = test_log(after, 8, 5e-4);
  for (std::size_t k = 300; k < log.powered.size(); ++k) log.powered[k] = false;
  double readings = 0, of_before = 0, of_after = 0;
  for (const PhaseError& one : errors_by_phase({log}, before, after)) {
    readings += one.readings;
    of_before += one.readings * one.before;
    of_after += one.readings * one.after;
    if (one.phase == Phase::unpowered) CHECK(one.readings == close_to(0.25));
  }
  CHECK(readings == close_to(1));
  CHECK(of_before == close_to(error_of(before, log)));
  CHECK(of_after == close_to(error_of(after, log)));
}

TEST_CASE("a pendulum that swings freely speeds up and slows down equally often") {
  Drive<double> drive = planted_drive(Term::dry, 0);
  drive[Term::stall_torque] = 0, drive[Term::back_emf] = 0, drive[Term::dry] = 0;
  MotionLog log = test_log(drive, 8, 0, 1, 0.5);
  double up = 0, down = 0;
  for (const PhaseError& one : errors_by_phase({log}, drive, drive)) {
    if (one.phase == Phase::speeding_up) up = one.readings;
    if (one.phase == Phase::slowing_down) down = one.readings;
  }
  // Five swings of about 0.85 s: the last one is cut within a quarter, 1 / 19 of all.
  CHECK(up == close_to(down).epsilon(0.12));
}

}  // namespace plumbline::motion
