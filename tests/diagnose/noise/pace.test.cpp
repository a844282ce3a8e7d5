/// Noise that remembers, in runs that are read at different paces.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/gap.hpp"
#include "diagnose/noise/noise_steps.hpp"
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

/// Noise of the declared sigma whose neighbours correlate so, from the seconds between them.
std::vector<double> remembering(const Experiment& experiment, const Measurements& measurements,
                                const std::function<double(double)>& correlation, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> noise(measurements.size());
  for (const Series& series : measurements.series()) {
    const std::vector<Reading>& readings = experiment.runs[series.run].readings;
    const double phi = correlation(readings[1].t - readings[0].t);
    double state = normal(random);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      noise[series.first + i] = state;
      state = phi * state + std::sqrt(1 - phi * phi) * normal(random);
    }
  }
  return noise;
}

std::function<double(double)> filter(double time) {
  return [time](double seconds) { return std::exp(-seconds / time); };
}

std::function<double(double)> always(double phi) {
  return [phi](double) { return phi; };
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

TEST_CASE("what neighbours correlate goes with the time between them where noise is forgotten with time") {
  const Experiment experiment = read_every({2, 0.5}, 200);
  const Measurements measurements(experiment);
  const double phi = std::exp(-0.5 / 2.24);
  const NoiseModel noise{{1, 1, 1, 1, 1}, {0, phi, 0}, {{false, true, false}, {}}};
  for (const Series& series : measurements.series())
    CHECK(noise.correlation_of(series) == close_to(series.run == 0 ? std::pow(phi, 4) : phi));
  std::mt19937_64 random(5);
  for (int draw = 0; draw < 10; ++draw) {
    const std::vector<double> white =
        whiten(measurements, remembering(experiment, measurements, filter(2.24), random), noise);
    double squares = 0;
    for (const double z : white) squares += z * z / static_cast<double>(white.size());
    CHECK(squares == doctest::Approx(1).epsilon(4 * std::sqrt(2.0 / 800)));
  }
}

TEST_CASE("readings say whether their noise is forgotten with time or with every reading") {
  const Experiment experiment = read_every({2, 0.5}, 200);
  const Measurements measurements(experiment);
  std::mt19937_64 random(5);
  const double phi = std::exp(-0.5 / 2.24);
  for (int draw = 0; draw < 20; ++draw) {
    const auto estimated = [&](const std::function<double(double)>& correlation) {
      return estimate_noise(measurements, remembering(experiment, measurements, correlation, random));
    };
    // Two channels of 200 values tell the correlation of each run. At the slow pace it is 0.41 with time, 0.8
    // without, four deviations off.
    const NoiseModel with_time = estimated(filter(2.24)), with_readings = estimated(always(phi));
    CHECK(with_time.manner.with_time[at_force]);
    CHECK_FALSE(with_readings.manner.with_time[at_force]);
    CHECK(std::abs(with_time.correlation[at_force] - phi) < 3 * correlation_deviation(phi, 400));
    CHECK(std::abs(with_readings.correlation[at_force] - phi) < 3 * correlation_deviation(phi, 800));
  }
  // What does not remember is forgotten with every reading, and at one pace there is no telling.
  const Experiment one_pace = read_every({2, 2}, 200);
  const Measurements alike(one_pace);
  CHECK_FALSE(
      estimate_noise(alike, remembering(one_pace, alike, filter(5), random)).manner.with_time[at_force]);
}

TEST_CASE("noise that remembers for seconds, or for readings, is no gap in runs that are read at any pace" *
          doctest::test_suite("long")) {
  const Experiment experiment = read_every({0.5, 20, 2, 5}, 50);
  const Measurements measurements(experiment);
  constexpr int draws = 100;
  const auto alarms = [&](const std::function<double(double)>& correlation, double gap) {
    std::mt19937_64 random(8);
    int called = 0;
    for (int draw = 0; draw < draws; ++draw) {
      std::vector<double> residual = remembering(experiment, measurements, correlation, random);
      for (const Series& series : measurements.series())
        for (std::size_t i = 0; i < series.readings.size(); ++i)
          residual[series.first + i] += gap * std::pow(static_cast<double>(i) / 50, 2);
      called += test_gap(measurements, residual).p_value < beliefs::gap_level;
    }
    return called;
  };
  // A count of 5 % in 100 deviates by 2.2: more than 12 is more than three deviations above.
  for (const auto& correlation : {filter(5), always(0.7), always(0.9)}) CHECK(alarms(correlation, 0) <= 12);
  CHECK(alarms(filter(5), 6) == draws);
}
