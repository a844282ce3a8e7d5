#include "diagnose/motion/next_motion.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/motion/roll_out.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

Bench bench_of(double sigma) {
  Bench bench;
  bench.sigma = sigma;
  for (const double gain : {4.0, 16.0}) bench.logs.push_back(test_log(planted_drive(Term::dry, 0), gain, 0));
  return bench;
}

}  // namespace

TEST_CASE("at one speed a delay is friction, and the next motion is one with others") {
  const std::optional<NextMotion> next = next_motion(bench_of(5e-4), planted_drive(Term::command_delay, 0.03),
                                                     planted_drive(Term::viscous, 0.08));
  REQUIRE(next);
  CHECK(next->apart > 5e-4);
  CHECK(next->words.find("0.1 Hz") == std::string::npos);
}

TEST_CASE("another mass of the load shows beside the load alone") {
  const std::optional<NextMotion> next =
      next_motion(bench_of(5e-4), planted_drive(Term::load_mass, 0), planted_drive(Term::load_mass, 0.2));
  REQUIRE(next);
  CHECK(next->words.find("without the load") == std::string::npos);
}

TEST_CASE("no motion tells a drive from itself") {
  const Drive<double> drive = planted_drive(Term::dry, 0.02);
  CHECK(!next_motion(bench_of(5e-4), drive, drive));
}

TEST_CASE(
    "a slow log is the static limit: the joint lags behind its command by what gravity and friction need") {
  constexpr double friction = 0.06, gain = 0.16 * 16, torque = 0.3 * 12;
  MotionLog log = test_log(planted_drive(Term::dry, 0), 16, 0);
  log.time.clear(), log.command.clear();
  for (int k = 0; k < 400; ++k) {  // 0.5 rad up in 20 s, and down again
    log.time.push_back(0.1 * k);
    log.command.push_back(0.5 - 0.5 * std::abs(1 - k / 200.0));
  }
  const std::vector<double> angle =
      angles_of(planted_drive(Term::dry, 0), log, {0, 0, log.time.size()}, 0.0, 0.0);
  for (const std::size_t k : {100U, 180U, 220U, 260U}) {
    CAPTURE(k);
    // Balance at rest, friction against the motion; beside it damping at 0.025 rad/s and half a held command,
    // 1.25 mrad: 0.25 N m s/rad 0.025 / 9.2 N m/rad is 0.7 mrad.
    const double way = k < 200 ? 1 : -1, weight = 0.59 * std::sin(angle[k] + 0.01);
    const double expected = log.command[k] - (weight + way * friction) / (gain * torque);
    CHECK(std::abs(angle[k] - expected) < 3e-3);
    CHECK(std::abs(angle[k] - log.command[k]) > 3e-3);  // what is checked is larger than the tolerance
  }
}

}  // namespace plumbline::motion
