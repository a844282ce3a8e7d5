#include "diagnose/motion/log_look.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/close_to.hpp"

namespace plumbline::motion {
namespace {

constexpr double reading_noise = 6e-4;

/// A joint at 50 Hz that turns with 150 rad/s^2, as a fast servo after a step: back and forth on parabolas.
MotionLog bouncing_log() {
  constexpr double period = 0.2, acceleration = 150;
  MotionLog log;
  for (int k = 0; k < 100; ++k) {
    const double t = 0.02 * k, since = std::fmod(t, period) - period / 2;
    log.time.push_back(t), log.position.push_back(acceleration / 2 * since * since);
  }
  return log;
}

}  // namespace

TEST_CASE("where a fast motion turns no reading is a spike") {
  MotionLog log = bouncing_log();
  const std::vector<double> read = log.position;
  mend_spikes(log, reading_noise);
  CHECK(log.spikes == 0);
  CHECK(log.position == read);
}

TEST_CASE("one reading far from all its neighbours is replaced by the mean of the nearest two") {
  MotionLog log = bouncing_log();
  std::fill(log.position.begin() + 50, log.position.end(), log.position[50]);
  log.position[70] += 0.3;
  mend_spikes(log, reading_noise);
  CHECK(log.spikes == 1);
  CHECK(log.position[70] == close_to(log.position[50]));
}

}  // namespace plumbline::motion
