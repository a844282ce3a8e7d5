/// Pulleys and cameras of the bench, in closed form.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// A load that grows and falls again, with the reading at each size once on either way.
Experiment loaded_and_unloaded() {
  Experiment experiment = three_links();
  load(experiment, {0.2, 0.3, -0.3}, {-0.5, 0.2}, {-1.5, 0.8}, 10);
  std::vector<Reading>& readings = experiment.runs[0].readings;
  for (std::size_t i = 10; i-- > 0;) {
    readings.push_back(readings[i]);
    readings.back().t = static_cast<double>(readings.size() - 1);
  }
  return experiment;
}

Trace predicted_load(const Experiment& experiment, const Candidate& candidate,
                     const std::vector<double>& value) {
  const Prediction prediction = predict(Study(experiment), candidate, value);
  REQUIRE(prediction.reached);
  return prediction.runs[0];
}

bool is_possible(const Experiment& experiment, const char* id) {
  const std::vector<EffectAt> possible = possible_effects(Study(experiment));
  return std::find(possible.begin(), possible.end(), EffectAt(id)) != possible.end();
}

/// Equilibria are solved to ten digits of lengths and angles of about one.
constexpr double solver_digits = 1e-9;

}  // namespace

TEST_CASE("over a pulley a load passes exp(-mu) of itself while it grows and exp(mu) while it falls") {
  const double mu = 0.1;
  for (const bool by_weights : {false, true}) {
    Experiment experiment = loaded_and_unloaded();
    experiment.runs[0].by_weights = by_weights;
    Experiment passed = experiment;
    for (std::size_t i = 0; i < passed.runs[0].readings.size(); ++i) {
      Reading& one = passed.runs[0].readings[i];
      const double share = std::exp(i <= 10 ? -mu : mu);
      one[column_Fx] *= share, one[column_Fy] *= share;
    }
    const Trace with = predicted_load(experiment, only("pulley_friction"), {mu}),
                nominal = predicted_load(passed, {}, {});
    for (const ChannelColumn column : {column_x, column_y})
      CHECK(difference(with.col(column), nominal.col(column)) < solver_digits);
    CHECK(difference(with.rightCols(3), nominal.rightCols(3)) < solver_digits);
    // The dial shows what hangs there.
    CHECK(with(4, column_Fx) == experiment.runs[0].readings[4][column_Fx]);
  }
}

TEST_CASE("a load that stays passes the pulley as it did before") {
  Experiment experiment = loaded_and_unloaded();
  std::vector<Reading>& readings = experiment.runs[0].readings;
  readings.insert(readings.begin() + 15, readings[15]);
  for (std::size_t i = 0; i < readings.size(); ++i) readings[i].t = static_cast<double>(i);
  const Trace with = predicted_load(experiment, only("pulley_friction"), {0.1});
  CHECK(difference(with.row(15), with.row(16)) < solver_digits);
}

TEST_CASE("a camera that is scaled or turned shows the end point so, and nothing else differently") {
  const Experiment experiment = loaded_and_unloaded();
  const Trace nominal = predicted_load(experiment, {}, {});
  const Trace scaled = predicted_load(experiment, only("camera_scale"), {0.05});
  for (const ChannelColumn column : {column_x, column_y})
    CHECK(difference(scaled.col(column), 1.05 * nominal.col(column)) < solver_digits);
  const double eps = 0.2;
  const Trace turned = predicted_load(experiment, only("camera_turn"), {eps});
  CHECK(difference(turned.col(column_x), std::cos(eps) * nominal.col(column_x) -
                                             std::sin(eps) * nominal.col(column_y)) < solver_digits);
  CHECK(difference(turned.col(column_y), std::sin(eps) * nominal.col(column_x) +
                                             std::cos(eps) * nominal.col(column_y)) < solver_digits);
  for (const Trace* shown : {&scaled, &turned})
    CHECK(difference(shown->rightCols(5).rightCols(3), nominal.rightCols(3)) < solver_digits);
  // Where the drive leads the end point, no camera is asked where it is.
  Experiment pressed = three_links();
  press(pressed, {0.3, -0.5, 0.4}, {-0.04, 0.01}, 6, true);
  for (const char* id : {"camera_scale", "camera_turn"})
    CHECK(difference(predicted_load(pressed, only(id), {0.1}), predicted_load(pressed, {}, {})) == 0);
}

TEST_CASE("a pulley shows where a load turns back, a camera where it sees the end point") {
  Experiment experiment = loaded_and_unloaded();
  CHECK(is_possible(experiment, "pulley_friction"));
  CHECK(is_possible(experiment, "camera_scale"));
  CHECK(is_possible(experiment, "camera_turn"));
  experiment.runs[0].readings.resize(11);
  CHECK_FALSE(is_possible(experiment, "pulley_friction"));
  for (Reading& one : experiment.runs[0].readings) one[column_x] = one[column_y] = nan_value();
  CHECK_FALSE(is_possible(experiment, "camera_scale"));
  CHECK_FALSE(is_possible(experiment, "camera_turn"));
  Experiment pressed = three_links();
  press(pressed, {0.3, -0.5, 0.4}, {-0.04, 0.01}, 6, true);
  CHECK_FALSE(is_possible(pressed, "pulley_friction"));
  CHECK_FALSE(is_possible(pressed, "camera_scale"));
}
