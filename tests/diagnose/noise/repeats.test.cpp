#include "diagnose/noise/repeats.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "diagnose/beliefs.hpp"
#include "diagnose/noise/gap.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const std::vector<double> shape{0.3, -0.5, 0.4};

/// The same press so often, forces alone read.
Experiment pressed(int times, int steps) {
  Experiment experiment = three_links();
  experiment.noise.q = 0;
  for (int i = 0; i < times; ++i) press(experiment, shape, {-0.06, 0}, steps, true);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.q.clear();
  return experiment;
}

/// As the nominal chain gives them, with noise so many times the declared, and a ripple along the way whose
/// period is 1.7 of the steps between readings, and which has the sign of the motion: on the way back nothing
/// tells it from noise.
Experiment read_from(Experiment experiment, double noise, double ripple, unsigned seed) {
  const Experiment exact = experiment;
  experiment.noise.Fx *= noise;
  experiment.noise.Fy *= noise;
  experiment = measured(experiment, {}, {}, seed);
  for (Run& run : experiment.runs) {
    const double step = std::abs(run.readings[1].x - run.readings[0].x);
    const std::size_t half = run.readings.size() / 2;
    for (std::size_t i = 0; i < run.readings.size(); ++i) {
      Reading& reading = run.readings[i];
      const double sign = i <= half ? 1 : -1;
      reading.Fx +=
          sign * ripple * exact.noise.Fx * std::sin(2 * std::numbers::pi * reading.x / (1.7 * step));
    }
  }
  experiment.noise = exact.noise;
  return experiment;
}

double scale_of_forces(const Experiment& experiment) {
  const Study study(experiment);
  return estimate_noise(study.measurements(), study.nominal_residual())
      .scale[static_cast<std::size_t>(Channel::Name::Fx)];
}

}  // namespace

TEST_CASE("runs between the same ends repeat each other, whichever they begin at; other runs do not") {
  Experiment experiment = pressed(2, 10);
  press(experiment, shape, {-0.06, 0}, 10, false);                                       // one way
  std::reverse(experiment.runs[2].readings.begin(), experiment.runs[2].readings.end());  // from its end
  press(experiment, shape, {-0.04, 0}, 10, true);                                        // less far
  press(experiment, shape, {0, -0.06}, 10, true);                                        // across
  press(experiment, {0.3, -0.5, 0.5}, {-0.06, 0}, 10, true);                             // from another shape
  double read = 0;  // what is read alike was copied
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) {
      reading.q.clear();
      reading.Fx = ++read;
      reading.Fy = -read;
    }
  const Study study(experiment);
  const std::vector<Repeats>& all = study.measurements().repeats();
  REQUIRE(all.size() == 2);  // Fx and Fy
  for (const Repeats& one : all) {
    CHECK(one.values.size() == 21 + 21 + 11);
    CHECK(one.between.size() > 20);
    for (const Between& value : one.between)
      for (const std::size_t place : {value.value, value.before, value.after})
        CHECK(place < one.values.size());
  }
  CHECK(all[0].channel == Channel{Channel::Name::Fx});
  std::set<std::size_t> values(all[0].values.begin(), all[0].values.end());
  CHECK(values.size() == all[0].values.size());
  for (const Series& series : study.measurements().series())
    CHECK(values.contains(series.first) == (series.run < 3 && series.channel == all[0].channel));
  CHECK(Study(pressed(1, 10)).measurements().repeats().empty());
}

TEST_CASE("what repeated runs say of the noise does not depend on the order in which they are listed") {
  Experiment experiment = read_from(pressed(3, 40), 1, 30, 3);
  const double before = scale_of_forces(experiment);
  std::rotate(experiment.runs.begin(), experiment.runs.begin() + 1, experiment.runs.end());
  // Sums of squares in another order: 1e-12 is far more than they round.
  CHECK(scale_of_forces(experiment) == close_to(before).epsilon(1e-12));
}

TEST_CASE("a ripple finer than the readings is no noise where a run is repeated, and noise stays noise") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const double alone = scale_of_forces(read_from(pressed(1, 40), 1, 30, seed)),
                 again = scale_of_forces(read_from(pressed(2, 40), 1, 30, seed)),
                 rough = scale_of_forces(read_from(pressed(2, 40), 5, 0, seed));
    // A sine of 30 sigmas has a standard deviation of 21.
    CHECK(alone > 10);
    // Room of 1.5 and two deviations of the mean square of some 80 values, which may be off by three of them.
    CHECK(again < (1.5 + 2 / std::sqrt(80.0)) * (1 + 3 / std::sqrt(2 * 40.0)));
    // A standard deviation of 160 values is right to 3 / sqrt(320), of neighbours' differences half as well.
    CHECK(rough == doctest::Approx(5).epsilon(2 * 3 / std::sqrt(320.0)));
  }
}

TEST_CASE("a run that was copied says nothing of the noise") {
  Experiment experiment = read_from(pressed(1, 40), 3, 0, 2);
  const double once = scale_of_forces(experiment);
  experiment.runs.push_back(experiment.runs.front());
  experiment.runs.back().id = "copied";
  // Twice the same steps are believed a little more: the prior weighs 16 values beside their 80.
  CHECK(scale_of_forces(experiment) == close_to(once).epsilon(0.1));
  CHECK(Study(experiment).measurements().repeats().empty());
}

TEST_CASE("what a repeated run shows is a gap, and noise of five times the declared is none") {
  const auto is_gap = [](const Experiment& experiment) {
    const Study study(experiment);
    return test_gap(study.measurements(), study.nominal_residual()).p_value < beliefs::gap_level;
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    CHECK(is_gap(read_from(pressed(2, 40), 1, 30, seed)));
    CHECK_FALSE(is_gap(read_from(pressed(2, 40), 5, 0, seed)));
  }
}
