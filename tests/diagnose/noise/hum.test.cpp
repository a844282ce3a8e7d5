#include "diagnose/noise/hum.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/gap.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// Adds the same tone, of an amplitude in declared sigmas, to every series.
void add_tone(const Measurements& measurements, double period, double amplitude,
              std::vector<double>& residual) {
  for (const Series& series : measurements.series())
    for (std::size_t i = 0; i < series.readings.size(); ++i)
      residual[series.first + i] +=
          amplitude * std::sin(0.7 + 2 * std::numbers::pi * static_cast<double>(i) / period);
}

}  // namespace

TEST_CASE("a tone of two sigmas is found with its period and size, and is no gap") {
  const Measurements measurements(blank_experiment({60, 90}));
  std::mt19937_64 random(41);
  for (const double period : {2.3, 3.7, 5.0, 8.9}) {
    CAPTURE(period);
    int alarms = 0;
    constexpr int draws = 20;
    for (int draw = 0; draw < draws; ++draw) {
      std::vector<double> residual = correlated_noise(measurements, 1, 0, random);
      add_tone(measurements, period, 2, residual);
      const std::vector<Hum> hum = find_hum(measurements, residual);
      REQUIRE(hum.size() >= measurements.series().size());
      // A frequency is known to sqrt(6) / (pi A m^1.5), 9e-4 for 60 readings; the grid is 1 / (4 m) wide.
      for (const Hum& one : hum)
        if (one.rms() > 1) CHECK(std::abs(1 / one.period - 1 / period) < 4 * 9e-4 + 1.0 / (8 * 60));
      alarms += test_gap(measurements, residual).p_value < beliefs::gap_level;
    }
    CHECK(alarms <= 3);  // of 20 where one in a hundred is meant: four have a chance of 4e-5
  }
}

TEST_CASE("a tone that is fast in one run is known in another of its channel where it is slow") {
  // Twenty seconds: seven readings of the first run, where they are 3 s apart, 24 of the other, two and a
  // half times round.
  Experiment experiment = blank_experiment({40, 60});
  for (Reading& reading : experiment.runs[0].readings) reading.t *= 3;
  for (Reading& reading : experiment.runs[1].readings) reading.t *= 20.0 / 24;
  const Measurements measurements(experiment);
  std::mt19937_64 random(43);
  int alarms = 0, slow_alone = 0, others = 0;
  constexpr int draws = 20;
  for (int draw = 0; draw < draws; ++draw) {
    const auto residual = [&](double in_first, double period) {
      std::vector<double> all = correlated_noise(measurements, 1, 0, random);
      for (const Series& series : measurements.series())
        for (std::size_t i = 0; i < series.readings.size(); ++i) {
          const double t = experiment.runs[series.run].readings[i].t;
          all[series.first + i] += (series.run == 0 ? in_first : 2) *
                                   std::sin(0.7 + 2 * std::numbers::pi * t / (series.run == 0 ? 20 : period));
        }
      return all;
    };
    alarms += test_gap(measurements, residual(2, 20)).p_value < beliefs::gap_level;
    // What nothing else vouches for stays a gap: alone, of another period, or four times as loud.
    slow_alone += test_gap(measurements, residual(0, 20)).p_value < beliefs::gap_level;
    others += test_gap(measurements, residual(2, 40)).p_value < beliefs::gap_level;
    others += test_gap(measurements, residual(0.5, 20)).p_value < beliefs::gap_level;
  }
  CHECK(alarms <= 3);  // of 20 where one in a hundred is meant: four have a chance of 4e-5
  // One of twenty was taken for noise that is forgotten with time, which would be slow in the fast run alone.
  CHECK(slow_alone >= draws - 1);
  // One of forty was no more than noise that is larger in places.
  CHECK(others >= 2 * draws - 1);
}

TEST_CASE("noise has no tone, of whatever correlation; a ripple larger than noise may be is none either") {
  const Measurements measurements(blank_experiment({60, 90}));
  std::mt19937_64 random(42);
  for (const double correlation : {0.0, 0.6}) {
    int tones = 0;
    for (int draw = 0; draw < 100; ++draw)
      tones += !find_hum(measurements, correlated_noise(measurements, 1, correlation, random)).empty();
    CHECK(tones <= 4);  // of 100 with two series at a level of 1e-3 each: five have a chance of 2e-6
  }
  std::vector<double> ripple = correlated_noise(measurements, 1, 0, random);
  add_tone(measurements, 5, 1.1 * std::numbers::sqrt2 * beliefs::largest_hum, ripple);
  CHECK(find_hum(measurements, ripple).empty());
  CHECK(test_gap(measurements, ripple).p_value < beliefs::gap_level);
}

TEST_CASE("what is left without its tones is what was there before them") {
  const Measurements measurements(blank_experiment({60, 90}));
  std::vector<double> residual(measurements.size(), 0.0);
  add_tone(measurements, 6, 2, residual);  // a period that the grid of frequencies has for both lengths
  std::vector<Hum> hum;
  for (std::size_t s = 0; s < measurements.series().size(); ++s)
    hum.push_back({s, 6, 2 * std::sin(0.7), 2 * std::cos(0.7)});
  for (const double left : without_hum(measurements, residual, hum)) CHECK(std::abs(left) < 1e-12);
}
