#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "diagnose/noise/hum.hpp"
#include "diagnose/noise/proportional_noise.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// A run that goes to and fro along x in cycles of so many steps, from `off` of a step on in each cycle more.
Experiment cycles(int count, int steps, double off = 0) {
  Experiment experiment = three_links();
  Run run{"cycles", Control::end_point, {0.3, -0.5, 0.4}, {}};
  for (int i = 0; i < count * steps; ++i) {
    const double along = std::abs(1 - 2 * std::fmod(static_cast<double>(i) / steps, 1.0));
    const double x = 0.5 - 0.04 * along + 0.01 * off * std::floor(static_cast<double>(i) / steps);
    run.readings.push_back({2.0 * i, x, 0.02, 0, 0, {}});
  }
  experiment.runs = {run};
  return experiment;
}

/// What a function of the place of the readings leaves, in sigmas, beside noise as it was declared.
template <class Law>
std::vector<double> left_by(const Experiment& experiment, const Measurements& measurements, Law law,
                            std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> residual(measurements.size());
  for (const Series& series : measurements.series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      residual[series.first + i] = law(experiment.runs[0].readings[series.readings[i]].x, i) + normal(random);
  return residual;
}

}  // namespace

TEST_CASE("a value is compared with those that were read beside it on another way, by hand") {
  // To and fro in four steps: places 0 1 2 1 0 1 2 1 of the way; fewer than three readings apart is no other
  // time. On the ways to one side the second cycle comes to the places of the first.
  const Experiment experiment = cycles(5, 4);
  const Measurements measurements(experiment);
  REQUIRE(measurements.series().size() == 2);
  for (const Between& one : measurements.series().front().between) {
    const auto x = [&](std::size_t i) { return experiment.runs[0].readings[i].x; };
    CHECK(std::max(one.value, one.before) - std::min(one.value, one.before) > 2);
    CHECK(std::max(one.value, one.after) - std::min(one.value, one.after) > 2);
    CHECK(x(one.value) == close_to((1 - one.share) * x(one.before) + one.share * x(one.after)));
  }
  CHECK(measurements.series().front().between.size() > 10);
  const std::vector<double> values{1, 2, 6};
  CHECK(Between{1, 0, 2, 0.25}.off(values.data()) == close_to((2 - 2.25) / std::sqrt(1 + 0.0625 + 0.5625)));
  const Differences in_place(values, 0.5, {{1, 0, 2, 0.25}});
  CHECK(in_place.sizes[0] == close_to(-0.25 / std::sqrt(1.625) / 0.5));
  CHECK(in_place.levels[0] == close_to(std::sqrt((4 + 0.5625 + 2.25) / 1.625)));
  // a way that is gone once has no other
  Experiment once = cycles(1, 40);
  once.runs[0].readings.resize(20);
  const Measurements one_way(once);
  CHECK(one_way.series().front().between.empty());
}

TEST_CASE("the curve of a coarsely sampled cycle is no noise") {
  std::mt19937_64 random(3);
  for (const double off : {0.0, 0.3}) {
    const Experiment experiment = cycles(6, 12, off);
    const Measurements measurements(experiment);
    const double places = static_cast<double>(measurements.series().front().between.size());
    REQUIRE(places > 24);
    for (int draw = 0; draw < 20; ++draw) {
      const auto hardening = left_by(
          experiment, measurements, [](double x, std::size_t) { return 4e6 * std::pow(x - 0.48, 3); },
          random);
      const NoiseModel noise = estimate_noise(measurements, hardening);
      // Steps of the curve are up to ten sigmas; room is left for chance, and two deviations of it more here.
      CHECK(noise.scale[static_cast<std::size_t>(Channel::Name::Fx)] <
            (1.5 + 2 / std::sqrt(places)) * (1 + 2 / std::sqrt(places)) * 1.3);
      // but noise that is larger than was declared is seen
      const auto rough = left_by(
          experiment, measurements, [](double, std::size_t) { return 0; }, random);
      std::vector<double> larger = rough;
      for (double& one : larger) one *= 3;
      CHECK(estimate_noise(measurements, larger).scale[2] > 2);
    }
  }
}

TEST_CASE("what comes and goes with the place is no hum, and no noise in proportion") {
  std::mt19937_64 random(4);
  const Experiment experiment = cycles(8, 12, 0.05);
  const Measurements measurements(experiment);
  int with_the_path = 0, beside_it = 0;
  for (int draw = 0; draw < 20; ++draw) {
    const auto wave = [](double rounds, std::size_t i) {
      return 3 * std::cos(2 * std::numbers::pi * rounds * static_cast<double>(i));
    };
    with_the_path +=
        find_hum(measurements, left_by(
                                   experiment, measurements,
                                   [&](double, std::size_t i) { return wave(1 / 12.0, i); }, random))
            .empty();
    beside_it += !find_hum(measurements, left_by(
                                             experiment, measurements,
                                             [&](double, std::size_t i) { return wave(1 / 7.3, i); }, random))
                      .empty();
  }
  CHECK(with_the_path == 20);
  CHECK(beside_it == 20);
  // A stop where the force is large, of which a leg has two readings: third differences are large there too.
  Experiment stopped = experiment;
  std::normal_distribution<double> normal;
  for (Reading& reading : stopped.runs[0].readings) {
    const double force = 100 * (0.48 - reading.x) + 4000 * std::max(0.0, 0.475 - reading.x);
    reading.Fx = force + stopped.noise.Fx * normal(random), reading.Fy = stopped.noise.Fy * normal(random);
  }
  const Measurements of_stop(stopped);
  CHECK(of_stop.series().front().proportion == 0);
}
