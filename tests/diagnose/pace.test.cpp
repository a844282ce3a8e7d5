/// Noise that remembers for a time, in runs that are read at different paces.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/gap.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Runs of so many readings, each at so many seconds from one to the next.
Experiment read_every(const std::vector<double>& seconds, std::size_t readings) {
  Experiment experiment = blank_experiment(std::vector<std::size_t>(seconds.size(), readings));
  for (std::size_t r = 0; r < seconds.size(); ++r)
    for (Reading& reading : experiment.runs[r].readings) reading.t *= seconds[r];
  return experiment;
}

/// Noise of the declared sigma of which 1/e is left after this time, s.
std::vector<double> remembering(const Experiment& experiment, const Measurements& measurements, double time,
                                std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> noise(measurements.size());
  for (const Series& series : measurements.series()) {
    const std::vector<Reading>& readings = experiment.runs[series.run].readings;
    const double phi = std::exp(-(readings[1].t - readings[0].t) / time);
    double state = normal(random);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      noise[series.first + i] = state;
      state = phi * state + std::sqrt(1 - phi * phi) * normal(random);
    }
  }
  return noise;
}

}  // namespace

TEST_CASE("a pace is told by the clock, over that of the fastest run; alike it is the same") {
  const Experiment experiment = read_every({6, 2, 2.5, 0.5}, 10);
  const Measurements measurements(experiment);
  for (const Series& series : measurements.series())
    CHECK(series.pace == close_to(std::vector{12.0, 4.0, 4.0, 1.0}[series.run]));
  Experiment made_up = read_every({1, 1}, 10);  // a clock that counts the readings
  for (Reading& reading : made_up.runs[1].readings) reading.t = 0;
  const Measurements counted(made_up);
  for (const Series& series : counted.series()) CHECK(series.pace == 1);
}

TEST_CASE("what neighbours correlate goes with the time between them") {
  const Experiment experiment = read_every({2, 0.5}, 200);
  const Measurements measurements(experiment);
  const NoiseModel noise{{1, 1, 1, 1, 1}, {0, 0.8, 0}};
  for (const Series& series : measurements.series())
    CHECK(noise.correlation_of(series) == close_to(series.run == 0 ? std::pow(0.8, 4) : 0.8));
  std::mt19937_64 random(5);
  // 400 values of the fastest run, and 400 that tell less: three deviations of what they tell.
  const double phi = std::exp(-0.5 / 2.24);
  for (int draw = 0; draw < 10; ++draw) {
    const NoiseModel found =
        estimate_noise(measurements, remembering(experiment, measurements, 2.24, random));
    CHECK(std::abs(found.correlation[at_force] - phi) < 3 * correlation_deviation(phi, 400));
    const std::vector<double> white = whiten(
        measurements, remembering(experiment, measurements, 2.24, random), {{1, 1, 1, 1, 1}, {0, phi, 0}});
    double squares = 0;
    for (const double z : white) squares += z * z / static_cast<double>(white.size());
    CHECK(squares == doctest::Approx(1).epsilon(4 * std::sqrt(2.0 / 800)));
  }
}

TEST_CASE("noise that remembers for seconds is no gap in runs that are read at any pace" *
          doctest::test_suite("long")) {
  const Experiment experiment = read_every({0.5, 20, 2, 5}, 50);
  const Measurements measurements(experiment);
  std::mt19937_64 random(8);
  int alarms = 0, found = 0;
  constexpr int draws = 100;
  for (int draw = 0; draw < draws; ++draw) {
    std::vector<double> residual = remembering(experiment, measurements, 5, random);
    alarms += test_gap(measurements, residual).p_value < beliefs::gap_level;
    for (const Series& series : measurements.series())
      for (std::size_t i = 0; i < series.readings.size(); ++i)
        residual[series.first + i] += 3 * std::sin(0.12 * static_cast<double>(i));
    found += test_gap(measurements, residual).p_value < beliefs::gap_level;
  }
  // A count of 5 % in 100 deviates by 2.2: more than 12 is more than three deviations above.
  CHECK(alarms <= 12);
  CHECK(found == draws);
}
