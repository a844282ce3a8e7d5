#include "diagnose/decision/posterior.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/diagnose/bench.hpp"

using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Of readings of the nominal chain that scatter so many times as much as is declared.
Posterior with_noise(double times) {
  Experiment experiment = measured(full_bench(), {}, {}, 11);
  Noise& declared = experiment.noise;
  for (double& one : declared.sigma) one /= times;
  const Study study(experiment);
  return posterior(study, search(study));
}

}  // namespace

// Both densities of the scale, that of a nugget and that of noise (docs/how-it-decides.md), are equal at
// about four times.
TEST_CASE("a scatter of many times the declared noise is no noise") {
  for (const double times : {1.0, 2.0}) CHECK(with_noise(times).no_gap > 0.5);
  for (const double times : {8.0, 25.0}) {
    const Posterior found = with_noise(times);
    CHECK(found.no_gap < 0.5);
    CHECK(found.outside > 0.5);
  }
}

namespace {

/// Of readings of the nominal chain in which an angle of the first run, pressed and let back, is off by so
/// many declared standard deviations of each reading.
Posterior with_angle_off(const std::function<double(std::size_t reading, std::size_t count)>& sigmas) {
  Experiment experiment = measured(full_bench(), {}, {}, 11);
  std::vector<Reading>& readings = experiment.runs.front().readings;
  for (std::size_t i = 0; i < readings.size(); ++i)
    readings[i][column_q + 1] += experiment.noise[Channel::Name::q] * sigmas(i, readings.size());
  const Study study(experiment);
  return posterior(study, search(study));
}

}  // namespace

// Successive readings of a step differ by it once, and by noise else: autocorrelated noise of its size would
// have to stand still for half a run.
TEST_CASE("what slips or breaks in the course of a run is a gap, wherever it does") {
  for (const std::size_t at : {5, 12, 30})
    for (const double size : {8.0, -20.0}) {
      CAPTURE(at);
      CAPTURE(size);
      const Posterior found = with_angle_off([&](std::size_t i, std::size_t) { return i < at ? 0.0 : size; });
      CHECK(found.no_gap < 0.05);
      CHECK(found.outside > 0.5);
    }
}

TEST_CASE("what is there at rest and vanishes under load is a gap, as is the reverse") {
  for (const bool at_rest : {true, false}) {
    CAPTURE(at_rest);
    const Posterior found = with_angle_off([&](std::size_t i, std::size_t count) {
      const double half = static_cast<double>(count - 1) / 2,
                   pressed = 1 - std::abs(static_cast<double>(i) / half - 1);
      return 40 * std::max(0.0, (at_rest ? 1 - pressed : pressed) - 0.4);
    });
    CHECK(found.no_gap < 0.05);
  }
}

// As with a whole channel: both densities of the factor are equal at about four times. Of so few readings at
// ten times the likelihood has not decided yet whether the whole channel is noisier.
TEST_CASE("readings of a part of a run that scatter many times as much as the rest are no noise") {
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  const auto noisier = [&](double times) {
    return with_angle_off([&](std::size_t i, std::size_t) { return i < 20 ? 0.0 : times * normal(engine); });
  };
  CHECK(noisier(2.5).no_gap > 0.5);
  CHECK(noisier(30).no_gap < 0.5);
}
