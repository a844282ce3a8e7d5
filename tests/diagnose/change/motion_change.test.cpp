#include "diagnose/change/motion_change.hpp"

#include <doctest/doctest.h>

#include "diagnose/change/motion_change_report.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using motion::MotionLog, motion::Term;

namespace {

constexpr double encoder = 5e-4;

/// Logs of a drive that has a delay which its model lacks, and a term beside it.
motion::Bench logs_of(Term term, double value, double sigma, unsigned seed) {
  motion::Bench bench;
  bench.name = "servo";
  bench.nominal = motion::planted_drive(Term::command_delay, 0);
  bench.sigma = encoder;
  motion::Drive<double> drive = motion::planted_drive(Term::command_delay, 0.02);
  drive[term] += value;
  for (const double gain : {8.0, 16.0}) bench.logs.push_back(motion::test_log(drive, gain, sigma, seed++));
  return bench;
}

/// The largest difference of positions from what the model of the reference predicts of its own logs.
double left_of(const RelativeLogs& relative, const motion::Bench& reference) {
  double most = 0;
  for (std::size_t i = 0; i < reference.logs.size(); ++i) {
    const std::vector<double> predicted = motion::predicted(reference.nominal, reference.logs[i]);
    for (std::size_t k = 0; k < predicted.size(); ++k)
      most = std::max(most, std::abs(relative.bench.logs[i].position[k] - predicted[k]));
  }
  return most;
}

}  // namespace

TEST_CASE("what the model lacks under the same commands cancels, though it is many sigmas") {
  const motion::Bench one = logs_of(Term::dry, 0, 0, 1);
  const RelativeLogs relative = relative_to(one, one.nominal, 0, one);
  REQUIRE(relative.cancels);
  CHECK(motion::error_of(one.nominal, one.logs.back()) > 5 * encoder);
  CHECK(left_of(relative, one) < 1e-12);  // rounding of angles of a radian
  CHECK(relative.bench.sigma == close_to(std::sqrt(2.0) * encoder));
}

TEST_CASE("a clock that stands apart is no change") {
  const motion::Bench one = logs_of(Term::dry, 0, 0, 1);
  motion::Bench late = one;
  for (MotionLog& log : late.logs)
    for (double& t : log.time) t += 1e6;
  const RelativeLogs relative = relative_to(one, one.nominal, 0, late);
  REQUIRE(relative.cancels);
  CHECK(left_of(relative, one) < 1e-8);  // stamps of a million seconds are rounded by 1e-10 s, at some rad/s
}

TEST_CASE("logs under other commands are compared with the lack as noise, and it is said") {
  const motion::Bench one = logs_of(Term::dry, 0, 0, 1);
  motion::Bench other = one;
  for (MotionLog& log : other.logs)
    for (double& q : log.command) q = -q;
  const RelativeLogs relative = relative_to(one, one.nominal, 0.01, other);
  CHECK(!relative.cancels);
  CHECK(relative.logs.front().reference.empty());
  CHECK(relative.bench.sigma > 0.01);
}

TEST_SUITE_BEGIN("long");

TEST_CASE("a payload in motion is found within a twentieth, beside a delay that both states share") {
  constexpr double heavier = 0.2;
  const motion::Bench before = logs_of(Term::load_mass, 0, encoder, 11),
                      after = logs_of(Term::load_mass, heavier, encoder, 21);
  const MotionChange change = what_changed(before, after);
  INFO(as_text(change));
  REQUIRE(!change.diagnosis.causes.empty());
  const motion::NamedEffect& first = change.diagnosis.causes.front().effects.front();
  CHECK(first.id == "load_mass");
  CHECK(first.values.front().value == close_to(heavier).epsilon(0.05));
  CHECK(check(change) == Check::changed);
}

TEST_CASE("two sets of logs of one drive show no change, though its model lacks a delay") {
  const MotionChange change =
      what_changed(logs_of(Term::dry, 0, encoder, 31), logs_of(Term::dry, 0, encoder, 41));
  INFO(as_text(change));
  CHECK(change.diagnosis.verdict == CauseVerdict::none);
  CHECK(check(change) == Check::same);
}

TEST_SUITE_END();
