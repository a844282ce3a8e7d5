/// \file
/// Tones too soft to be heard in one series that a whole run has: found together, by the clock, and known
/// again in other runs; what is no tone stays a gap.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/gap.hpp"
#include "diagnose/noise/hum.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Runs in which forces and six joint angles are read.
Experiment eight_channels(const std::vector<std::size_t>& readings) {
  Experiment experiment = blank_experiment(readings);
  experiment.link_length.assign(6, 0.1);
  experiment.joint_stiffness.assign(6, 1);
  experiment.link_mass.assign(6, 0);
  experiment.noise.q = 1;
  for (Run& run : experiment.runs) {
    run.rest.assign(6, 0);
    for (Reading& reading : run.readings) reading.q.assign(6, 0);
  }
  return experiment;
}

/// White noise with this in every channel, by run and time.
std::vector<double> noise_and(const Experiment& experiment, const Measurements& measurements,
                              std::mt19937_64& random,
                              const std::function<double(std::size_t run, double t)>& more) {
  std::vector<double> all = correlated_noise(measurements, 1, 0, random);
  for (const Series& series : measurements.series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      all[series.first + i] += more(series.run, experiment.runs[series.run].readings[i].t);
  return all;
}

double wave(double amplitude, double period, double t) {
  return amplitude * std::sin(0.7 + 2 * std::numbers::pi * t / period);
}

std::size_t in_run(const Measurements& measurements, const std::vector<Hum>& hum, std::size_t run) {
  std::size_t series = 0;
  for (const Hum& one : hum) series += measurements.series()[one.series].run == run;
  return series;
}

constexpr int draws = 20;

}  // namespace

TEST_CASE(
    "a tone of 0.8 sigmas that eight channels share is found in all, and one of them mostly cannot tell") {
  const Experiment experiment = eight_channels({50});
  const Measurements measurements(experiment);
  REQUIRE(measurements.series().size() == 8);
  std::mt19937_64 random(44);
  int found = 0, alone = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto shared =
        noise_and(experiment, measurements, random, [](std::size_t, double t) { return wave(0.8, 4.3, t); });
    const std::vector<Hum> hum = find_hum(measurements, shared);
    bool right = in_run(measurements, hum, 0) == 8;
    // The grid is a quarter of an ordinate wide.
    for (const Hum& one : hum) right = right && std::abs(1 / one.period - 1 / 4.3) < 0.5 / 50;
    found += right;
    std::vector<double> soft = correlated_noise(measurements, 1, 0, random);
    const Series& first = measurements.series()[0];
    for (std::size_t i = 0; i < 50; ++i) soft[first.first + i] += wave(0.8, 4.3, static_cast<double>(i));
    alone += !find_hum(measurements, soft).empty();
  }
  // The tone is 0.3 of the energy of what is fast: by chance 2 x 21 (1 - 0.3)^20 = 0.03 for one series,
  // beyond the level of 1e-3 on average, and 3e-15 for eight.
  CHECK(found >= 18);
  CHECK(alone <= 10);
}

TEST_CASE("a soft tone goes by the clock where readings are uneven, and is known in a run where it is slow") {
  // 20 s: in the first run readings are 2 to 7 s apart, in the second 0.6 s: two rounds.
  Experiment experiment = eight_channels({60, 66});
  double t = 0;
  for (std::size_t i = 0; i < 60; ++i) {
    experiment.runs[0].readings[i].t = t;
    t += 2 + 5 * (0.5 + 0.5 * std::sin(0.37 * static_cast<double>(i)));
  }
  for (Reading& reading : experiment.runs[1].readings) reading.t *= 0.6;
  const Measurements measurements(experiment);
  std::mt19937_64 random(45);
  int alarms = 0, known = 0, unknown_period = 0, steps = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto hums =
        noise_and(experiment, measurements, random, [](std::size_t, double s) { return wave(1, 20, s); });
    const std::vector<Hum> hum = find_hum(measurements, hums);
    known += in_run(measurements, hum, 0) == 8 && in_run(measurements, hum, 1) == 8;
    alarms += test_gap(measurements, hums).p_value < beliefs::gap_level;
    // What only the slow run has stays a gap, and so does what is no tone: a step in every channel.
    const auto other = noise_and(experiment, measurements, random,
                                 [](std::size_t run, double s) { return run == 1 ? wave(1, 20, s) : 0; });
    unknown_period += test_gap(measurements, other).p_value < beliefs::gap_level;
    const auto step = noise_and(experiment, measurements, random,
                                [](std::size_t run, double s) { return run == 0 && s > 90 ? 2.0 : 0.0; });
    steps +=
        test_gap(measurements, step).p_value < beliefs::gap_level && find_hum(measurements, step).empty();
  }
  CHECK(known >= 18);
  CHECK(alarms <= 3);  // of 20 where one in a hundred is meant: four have a chance of 4e-5
  CHECK(unknown_period == draws);
  CHECK(steps >= 18);
}

TEST_CASE("what hums in forces and angles is known in positions, which no other run reads") {
  // The first run is under a force: of it the end point is read. 20 s are fast in the second alone.
  Experiment experiment = eight_channels({50, 60});
  experiment.noise.x = experiment.noise.y = 1;
  experiment.runs[0].control = Control::force;
  for (Reading& reading : experiment.runs[0].readings) reading.t *= 1.2;
  for (Reading& reading : experiment.runs[1].readings) reading.t *= 4;
  const Measurements measurements(experiment);
  std::mt19937_64 random(47);
  int known = 0, alarms = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto hums =
        noise_and(experiment, measurements, random, [](std::size_t, double t) { return wave(1.5, 20, t); });
    known += in_run(measurements, find_hum(measurements, hums), 0) == 8;
    alarms += test_gap(measurements, hums).p_value < beliefs::gap_level;
  }
  CHECK(known >= 18);
  CHECK(alarms <= 3);
}

TEST_CASE("eight channels of noise share no tone; what is larger than noise may be is none, shared or not") {
  const Experiment experiment = eight_channels({60, 45});
  const Measurements measurements(experiment);
  std::mt19937_64 random(46);
  for (const double correlation : {0.0, 0.6, 0.85}) {
    int tones = 0;
    for (int draw = 0; draw < 60; ++draw)
      tones += !find_hum(measurements, correlated_noise(measurements, 1, correlation, random)).empty();
    // 16 series and two runs at a level of 1e-3: 1.1 of 60 are meant, six have a chance of 1e-3.
    CHECK(tones <= 5);
  }
  const auto ripple = noise_and(experiment, measurements, random, [](std::size_t, double t) {
    return wave(1.1 * std::numbers::sqrt2 * beliefs::largest_hum, 5, t);
  });
  CHECK(find_hum(measurements, ripple).empty());
  CHECK(test_gap(measurements, ripple).p_value < beliefs::gap_level);
}
