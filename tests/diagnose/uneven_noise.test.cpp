#include "diagnose/model/uneven_noise.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "diagnose/model/measurement.hpp"
#include "diagnose/model/proportional_noise.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Third differences of noise of these deviations, one a joint.
std::vector<std::vector<double>> scattered(const std::vector<double>& deviations, std::size_t values,
                                           std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<std::vector<double>> sizes;
  for (const double deviation : deviations) {
    std::vector<double> readings(values);
    for (double& one : readings) one = deviation * normal(random);
    sizes.push_back(Differences(readings, 1).sizes);
  }
  return sizes;
}

}  // namespace

TEST_CASE(
    "joints that scatter alike are seldom told apart; one that scatters three times as much mostly is") {
  std::mt19937 random(11);
  constexpr int draws = 400;
  int false_alarms = 0, found = 0;
  double sum = 0;
  for (int draw = 0; draw < draws; ++draw) {
    for (const double times : uneven_noise(scattered({1, 1, 1, 1, 1}, 60, random))) false_alarms += times > 1;
    const std::vector<double> times = uneven_noise(scattered({1, 3, 1, 1, 1}, 60, random));
    CHECK(times.size() == 5);
    found += times[1] > 1;
    sum += times[1] > 1 ? std::log(times[1]) : 0;
  }
  // Five joints each time, one of 700 by chance; twenty would be a rate of one in 100.
  CHECK(false_alarms < 20);
  CHECK(found > 0.9 * draws);
  // Of the logarithm of a ratio, by the root of 1 / (0.37 * 60) a time.
  CHECK(std::abs(sum / found - std::log(3)) < 4 * std::sqrt(1 / (0.37 * 60) / draws) + 0.05);
}

TEST_CASE("two joints, and joints of few readings, are left as they were declared") {
  std::mt19937 random(5);
  CHECK(uneven_noise(scattered({1, 9}, 200, random)) == std::vector<double>{1, 1});
  CHECK(uneven_noise(scattered({1, 1, 9}, 12, random)) == std::vector<double>{1, 1, 1});
}

TEST_CASE("the angle of a joint with a worse encoder counts for less") {
  Experiment experiment = measured(full_bench(), {}, {}, 3);
  const Measurements even(experiment);
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 4 * experiment.noise.q);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings)
      if (reading.q.size() > 1) reading.q[1] += normal(random);
  const Measurements uneven(experiment);
  for (std::size_t s = 0; s < uneven.series().size(); ++s) {
    const Series& series = uneven.series()[s];
    const bool worse = series.channel == Channel{Channel::Name::q, 1};
    CHECK(even.series()[s].times == 1);
    CHECK(series.sigma == close_to(even.series()[s].sigma * (worse ? series.times : 1)));
    if (worse) CHECK(series.times == doctest::Approx(std::hypot(1, 4)).epsilon(0.3));
  }
}

TEST_CASE("the angle of a joint that is bent more than others, where all scatter in proportion, is as good") {
  Experiment experiment = three_links();
  for (int i = 0; i < 3; ++i) press(experiment, {0.1, -0.15, 1.2}, {-0.06, 0.01 * i}, 40, true);
  experiment = measured(experiment, {}, {}, 4);
  std::mt19937 random(8);
  std::normal_distribution<double> normal(0, 6 * experiment.noise.q);  // a radian
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings)
      for (double& q : reading.q) q += q * normal(random);
  const Measurements all(experiment);
  for (const Series& series : all.series()) {
    if (series.channel.name != Channel::Name::q) continue;
    CHECK(series.times == 1);
    CHECK(series.proportion * series.sigma == doctest::Approx(6 * experiment.noise.q).epsilon(0.25));
  }
}
