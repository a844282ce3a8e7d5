#include "diagnose/motion/repeats.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {

TEST_CASE("two runs that differ by noise alone are 2 sigma / sqrt(pi) apart") {
  const double sigma = 0.01;
  const MotionLog one = test_log(planted_drive(Term::dry, 0), 8, sigma, 1),
                  other = test_log(planted_drive(Term::dry, 0), 8, sigma, 2);
  const std::optional<double> apart = repeatability({&one, &other});
  REQUIRE(apart.has_value());
  // The mean of 400 values whose deviation is 0.75 of their mean: 15 % are four standard deviations.
  CHECK(*apart == close_to(2 * sigma / std::sqrt(std::numbers::pi)).epsilon(0.15));
}

TEST_CASE("logs of other gains, loads or commands are no repeats") {
  const Drive<double> drive = planted_drive(Term::dry, 0);
  const MotionLog one = test_log(drive, 8, 0);
  MotionLog heavier = one, elsewhere = one;
  heavier.inertia *= 2;
  for (double& command : elsewhere.command) command += 0.2;
  MotionLog stiffer = test_log(drive, 16, 0);
  for (const MotionLog* other : {&heavier, &elsewhere, &stiffer}) CHECK(!repeatability({&one, other}));
}

}  // namespace plumbline::motion
