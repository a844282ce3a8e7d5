#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/motion/channel_look.hpp"
#include "diagnose/motion/report.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

/// The log of a drive, with these channels read as the drive has them.
MotionLog with_channels(const Drive<double>& drive, double gain, const std::vector<Channel>& channels,
                        unsigned seed = 1) {
  MotionLog log = test_log(drive, gain, 0, seed);
  for (const Channel one : channels) log.beside.push_back({one, {}});
  const std::vector<std::vector<double>> read = readings_of(drive, log, {0, 0, log.time.size()}, 0.0, 0.0);
  log.position = read[0];
  for (std::size_t i = 0; i < channels.size(); ++i) log.beside[i].value = read[1 + i];
  return log;
}

void add_noise(std::vector<double>& values, double sigma, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0, sigma);
  for (double& x : values) x += noise(generator);
}

}  // namespace

TEST_CASE("a straight line that is read late is lower by slope times delay, from the first reading on") {
  MotionLog log;
  std::vector<double> course;
  for (int k = 0; k < 20; ++k)
    log.time.push_back(0.01 * k + 0.001 * (k % 3)), course.push_back(3 * log.time.back());
  const std::vector<double> read = late(course, log, {0, 0, 20}, 0.023);
  for (std::size_t k = 0; k < read.size(); ++k) CHECK(read[k] == close_to(3 * (log.time[k] - 0.023)));
}

TEST_CASE("the derivative by a delay of a reading is less the speed of what is read") {
  MotionLog log;
  std::vector<Dual<1>> course;
  for (int k = 0; k < 20; ++k) log.time.push_back(0.01 * k), course.emplace_back(2 * log.time.back());
  for (const Dual<1>& one : late(course, log, {0, 0, 20}, Dual<1>::variable(0.015, 0)))
    CHECK(one.derivative(0) == close_to(-2));
}

TEST_CASE("a speed that is read is the slope of the positions, and a duty what the error asks for") {
  const MotionLog log =
      with_channels(planted_drive(Term::command_delay, 0), 8, {Channel::velocity, Channel::duty});
  const std::vector<ChannelLook> looks = look_beside({log});
  REQUIRE(looks.size() == 2);
  for (const ChannelLook& one : looks) {
    CAPTURE(kind_of(one.channel).name);
    CHECK(one.left_out.empty());
    // Differences over 40 ms of sines up to 6 rad/s are low by (0.02 * 6)^2 / 6 < 0.3 %. Ages are
    // tried every 2 ms.
    CHECK(one.ratio == close_to(1).epsilon(0.02));
    CHECK(std::abs(one.late) < 0.003);
    CHECK(one.explained > 0.99);
  }
}

TEST_CASE("a duty that is read shows the delay of the command before any fit") {
  const MotionLog log = with_channels(planted_drive(Term::command_delay, 0.03), 8, {Channel::duty});
  const ChannelLook look = look_beside({log}).front();
  // Ages are tried every 2 ms.
  CHECK(look.late > 0.027);
  CHECK(look.late < 0.033);
}

TEST_CASE("readings without a sign, and those that change once in a while, are left out and said") {
  MotionLog log = with_channels(planted_drive(Term::command_delay, 0), 8, {Channel::torque, Channel::duty});
  for (double& x : log.beside[0].value) x = std::abs(x);
  for (std::size_t k = 0; k < log.time.size(); ++k) log.beside[1].value[k] = log.beside[1].value[k - k % 50];
  const std::vector<ChannelLook> looks = look_beside({log});
  REQUIRE(looks.size() == 2);
  CHECK(looks[0].channel == Channel::duty);
  CHECK(looks[0].left_out.starts_with("it changes every 0.5"));
  CHECK(looks[1].left_out == "it has no sign");
}

TEST_SUITE_BEGIN("long");

TEST_CASE("beside a duty a late reading of position is told from a late command") {
  for (const Term planted : {Term::position_delay, Term::command_delay}) {
    Bench bench;
    bench.name = "two clocks";
    bench.nominal = planted_drive(Term::command_delay, 0);
    bench.sigma = 5e-4, bench.sigma_beside[static_cast<std::size_t>(Channel::duty)] = 0.005;
    unsigned seed = 1;
    for (const double gain : {4.0, 8.0, 16.0}) {
      MotionLog log = with_channels(planted_drive(planted, 0.02), gain, {Channel::duty}, seed);
      add_noise(log.position, bench.sigma, seed++);
      add_noise(log.beside[0].value, 0.005, seed++);
      bench.logs.push_back(std::move(log));
    }
    const Diagnosis diagnosis = diagnose_motion(Study(bench));
    INFO(as_text(diagnosis));
    CHECK(diagnosis.verdict == diagnose::CauseVerdict::identified);
    REQUIRE(diagnosis.causes.size() == 1);
    REQUIRE(diagnosis.causes.front().effects.size() == 1);
    CHECK(diagnosis.causes.front().effects.front().id ==
          (planted == Term::position_delay ? "position_delay" : "command_delay"));
    CHECK(diagnosis.causes.front().effects.front().values.front().value == close_to(0.02).epsilon(0.02));
  }
}

TEST_SUITE_END();

}  // namespace plumbline::motion
