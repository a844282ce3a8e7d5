#include "diagnose/noise/proportional_noise.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/bench/median.hpp"
#include "diagnose/noise/gap.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A press: the force rises, yields and rises again.
double press_force(double along) {
  return 80 * std::sin(2.2 * along) + 30 * along * along;
}

/// Readings of it with the standard deviation sqrt(1 + (share·force)^2); neighbours correlate.
std::vector<double> readings(std::size_t count, double share, double correlation, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> values;
  double state = normal(random);
  for (std::size_t i = 0; i < count; ++i) {
    const double force = press_force(static_cast<double>(i) / static_cast<double>(count));
    values.push_back(force + std::hypot(1.0, share * force) * state);
    state = correlation * state + std::sqrt(1 - correlation * correlation) * normal(random);
  }
  return values;
}

}  // namespace

TEST_CASE("by what share of themselves readings scatter is found in them alone") {
  std::mt19937_64 random(3);
  for (const double correlation : {0.0, 0.6}) {
    std::vector<double> found;
    for (int draw = 0; draw < 40; ++draw)
      found.push_back(proportional_noise({Differences(readings(80, 0.05, correlation, random), 1),
                                          Differences(readings(120, 0.05, correlation, random), 1)}));
    // r is the share over what all readings scatter, which few of these show: a third of them in third
    // differences, and of those a fifth near zero force. It spreads by a third, its median by a fifteenth.
    CHECK(median(found) == close_to(0.05).epsilon(0.15));
  }
}

TEST_CASE("where no reading is small, all scatter as was declared beside their share of themselves") {
  // There is hardly a difference between 5 % beside the declared sigma and 7 % beside nothing. With nothing
  // the smallest readings would outweigh all others.
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int draw = 0; draw < 60; ++draw) {
    std::vector<Differences> runs;
    for (const std::size_t count : {80U, 120U}) {
      std::vector<double> values;
      for (std::size_t i = 0; i < count; ++i) {
        const double force = 15 + press_force(static_cast<double>(i) / static_cast<double>(count));
        values.push_back(force + std::hypot(1.0, 0.06 * force) * normal(random));
      }
      runs.emplace_back(values, 1);
    }
    // The share is over what all scatter, of which third differences may show half: up to twice as large,
    // where nothing beside it would make it 0.7, the most that is looked at.
    const double found = proportional_noise(runs);
    CAPTURE(draw);
    CHECK(found > 0.03);
    CHECK(found < 0.18);
  }
}

TEST_CASE("noise that is the same at every reading is not said to be in proportion") {
  std::mt19937_64 random(4);
  int found = 0;
  for (const double correlation : {0.0, 0.8}) {
    for (int draw = 0; draw < 200; ++draw) {
      std::vector<double> values = readings(100, 0, correlation, random);
      add_outliers(values, 0.02, 15, random);
      found += proportional_noise({Differences(values, 1)}) > 0 ? 1 : 0;
    }
  }
  CHECK(found <= 1);  // of 400
}

TEST_CASE("a channel that reads little but its noise has no noise in proportion") {
  // A force across the way, say: of itself the reading is large where its noise is.
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  int found = 0;
  for (int draw = 0; draw < 400; ++draw) {
    std::vector<Differences> runs;
    for (const std::size_t count : {56U, 55U, 25U}) {
      std::vector<double> values;
      for (std::size_t i = 0; i < count; ++i)
        values.push_back(press_force(static_cast<double>(i) / static_cast<double>(count)) / 100 +
                         normal(random));
      runs.emplace_back(values, 1);
    }
    found += proportional_noise(runs) > 0 ? 1 : 0;
  }
  CHECK(found <= 1);
}

TEST_CASE("a curve that its readings hardly follow has no noise in proportion") {
  std::vector<double> snapping, coarse;
  for (int i = 0; i < 60; ++i) {
    coarse.push_back(100 * std::exp(-0.2 * i));
    snapping.push_back(i < 40 ? 3.0 * i : 40 - 0.5 * i);
  }
  CHECK(proportional_noise({Differences(coarse, 1e-3)}) == 0);
  CHECK(proportional_noise({Differences(snapping, 1e-3)}) == 0);
}

TEST_CASE("readings taken twice at every step of a staircase, or about a turn, are of no use for it") {
  Experiment experiment = blank_experiment({12});
  Run& run = experiment.runs.front();
  const std::vector<double> stairs{0, 0, 1, 1, 2, 3, 4, 5, 4, 3, 2, 1};
  for (std::size_t i = 0; i < stairs.size(); ++i) run.readings[i].x = 0.3 + 0.01 * stairs[i];
  const std::vector<std::size_t> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  CHECK(goes_evenly(run, all) ==
        std::vector<bool>{false, false, false, true, true, false, false, true, true});
}

TEST_CASE("readings that scatter in proportion weigh less, and are no gap") {
  std::mt19937_64 random(5);
  constexpr double share = 0.06;
  int alarms = 0;
  constexpr int draws = 60;
  for (int draw = 0; draw < draws; ++draw) {
    Experiment experiment = blank_experiment({70, 70});
    for (Run& run : experiment.runs) {
      const std::vector<double> along = readings(run.readings.size(), share, 0, random),
                                across = readings(run.readings.size(), share, 0, random);
      for (std::size_t i = 0; i < along.size(); ++i) {
        run.readings[i].Fx = along[i];
        run.readings[i].Fy = across[i];
      }
    }
    const Measurements measurements(experiment);
    std::vector<double> residual;
    for (const Series& series : measurements.series()) {
      for (std::size_t i = 0; i < series.sigmas.size(); ++i) {
        const double value = series.channel.of(experiment.runs[series.run].readings[i]);
        CHECK(series.sigmas[i] == std::hypot(1.0, series.proportion * value));
        residual.push_back((value - press_force(static_cast<double>(i) / 70)) / series.sigmas[i]);
      }
    }
    alarms += test_gap(measurements, residual).p_value < 0.01 ? 1 : 0;
  }
  // One in a hundred; four of 60 with a probability of 3 in 1000.
  CHECK(alarms <= 3);
}
