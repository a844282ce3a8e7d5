#include "diagnose/noise/uneven_noise.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "diagnose/noise/measurement.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

using RoughGroups = std::vector<std::vector<SeenNoise>>;

/// A series that never came to the same place twice.
SeenNoise in_time(const std::vector<double>& values) {
  return {Differences(values, 1), {}};
}

/// Third differences of noise of these deviations, one a group.
RoughGroups scattered(const std::vector<double>& deviations, std::size_t values, std::mt19937& random) {
  std::normal_distribution<double> normal;
  RoughGroups groups;
  for (const double deviation : deviations) {
    std::vector<double> readings(values);
    for (double& one : readings) one = deviation * normal(random);
    groups.push_back({in_time(readings)});
  }
  return groups;
}

}  // namespace

TEST_CASE(
    "groups that scatter alike are seldom told apart; one that scatters three times as much mostly is") {
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
  // Five groups each time, one of 700 by chance; twenty would be a rate of one in 100.
  CHECK(false_alarms < 20);
  CHECK(found > 0.9 * draws);
  // Of the smaller of two measures, the median's logarithm scatters by the root of 1 / (0.37 * 60) a time.
  CHECK(std::abs(sum / found - std::log(3)) < 4 * std::sqrt(1 / (0.37 * 60) / draws) + 0.1);
}

TEST_CASE("of two groups the rougher one is told, and none of few readings, of a curve, or of zeros") {
  std::mt19937 random(5);
  const std::vector<double> of_two = uneven_noise(scattered({1, 9}, 200, random));
  CHECK(of_two[0] == 1);
  CHECK(of_two[1] == doctest::Approx(9).epsilon(0.4));
  CHECK(uneven_noise(scattered({1, 1, 9}, 12, random)) == std::vector<double>{1, 1, 1});
  RoughGroups one_is_a_curve = scattered({1, 1}, 100, random);
  std::vector<double> curve(100);
  for (std::size_t i = 0; i < curve.size(); ++i) curve[i] = 500 * std::sin(0.3 * static_cast<double>(i));
  one_is_a_curve.push_back({in_time(curve)});
  CHECK(uneven_noise(one_is_a_curve) == std::vector<double>{1, 1, 1});
  CHECK(uneven_noise({{}, {in_time(std::vector<double>(50, 2.0))}}) == std::vector<double>{1, 1});
}

TEST_CASE("a group is rougher by no more than its values differ where they are at the same place") {
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  RoughGroups groups = scattered({1, 1, 6}, 100, random);
  Differences in_place;
  for (int i = 0; i < 100; ++i) in_place.sizes.push_back(normal(random)), in_place.levels.push_back(0);
  groups[2][0].in_place = in_place;
  CHECK(uneven_noise(groups)[2] == 1);
  for (double& size : groups[2][0].in_place.sizes) size *= 6;
  CHECK(uneven_noise(groups)[2] == doctest::Approx(6).epsilon(0.4));
  groups[2][0].in_place.sizes.resize(19);  // too few to say
  groups[2][0].in_place.levels.resize(19);
  for (double& size : groups[2][0].in_place.sizes) size /= 6;
  CHECK(uneven_noise(groups)[2] == doctest::Approx(6).epsilon(0.4));
}

TEST_CASE("a run that is rougher than the others counts for less, in the sensor that is") {
  Experiment experiment = three_links();
  for (int i = 0; i < 3; ++i) press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0.02 * i}, 40, true);
  experiment = measured(experiment, {}, {}, 6);
  const Measurements before(experiment);
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  for (Reading& reading : experiment.runs[1].readings) {
    reading.Fx += 4 * experiment.noise.Fx * normal(random);
    reading.Fy += 4 * experiment.noise.Fy * normal(random);
  }
  const Measurements rough(experiment);
  for (std::size_t s = 0; s < rough.series().size(); ++s) {
    const Series &series = rough.series()[s], &smooth = before.series()[s];
    const bool is_rough = series.run == 1 && series.channel.sensor() == Sensor::force;
    CHECK(smooth.beside_runs == 1);
    CHECK(series.sigma == close_to(smooth.sigma * (is_rough ? series.beside_runs : 1)));
    if (is_rough) CHECK(series.beside_runs == doctest::Approx(std::hypot(1, 4)).epsilon(0.3));
  }
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
    CHECK(even.series()[s].beside_joints == 1);
    CHECK(series.sigma == close_to(even.series()[s].sigma * (worse ? series.beside_joints : 1)));
    if (worse) CHECK(series.beside_joints == doctest::Approx(std::hypot(1, 4)).epsilon(0.3));
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
    CHECK(series.beside_joints == 1);
    CHECK(series.proportion * series.sigma == doctest::Approx(6 * experiment.noise.q).epsilon(0.25));
  }
}
