#include "diagnose/noise/measurement.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Two links, a run under an imposed end point and one under an imposed force, every channel of its own
/// sigma.
Experiment two_runs() {
  Experiment experiment;
  experiment.name = "two runs";
  experiment.link_length = {0.2, 0.2};
  experiment.joint_stiffness = {1, 1};
  experiment.noise = {0.1, 0.2, 0.4, 0.8, 0.05};
  Run held{"held", Control::end_point, {0, 0}, {}};
  held.readings = {{0, 0.3, 0, 4, 8, {1, 2}}, {1, 0.2, 0, nan_value(), 16, {3, nan_value()}}};
  Run pushed{"pushed", Control::force, {0, 0}, {}};
  pushed.readings = {{0, 1, 2, -5, 0, {}}};
  experiment.runs = {held, pushed};
  return experiment;
}

}  // namespace

TEST_CASE("what is measured is listed channel by channel, without what is missing") {
  const Measurements measurements(two_runs());
  const auto& series = measurements.series();
  REQUIRE(series.size() == 6);
  const std::vector<std::string> labels{"Fx", "Fy", "q1", "q2", "x", "y"};
  const std::vector<double> sigmas{0.4, 0.8, 0.05, 0.05, 0.1, 0.2};
  const std::vector<std::size_t> first{0, 1, 3, 5, 6, 7};
  const std::vector<Sensor> sensors{Sensor::force, Sensor::force,    Sensor::angle,
                                    Sensor::angle, Sensor::position, Sensor::position};
  for (std::size_t s = 0; s < series.size(); ++s) {
    CAPTURE(labels[s]);
    CHECK(series[s].channel.label() == labels[s]);
    CHECK(series[s].sigma == sigmas[s]);
    CHECK(series[s].first == first[s]);
    CHECK(series[s].channel.sensor() == sensors[s]);
    CHECK(series[s].run == (s < 4 ? 0 : 1));
  }
  CHECK(series[0].readings == std::vector<std::size_t>{0});
  CHECK(series[1].readings == std::vector<std::size_t>{0, 1});
  CHECK(measurements.size() == 8);
}

TEST_CASE("what readings are rounded to is the step of which their differences are multiples, in sigmas") {
  const auto step_of = [](const std::vector<double>& values) {
    Experiment experiment = two_runs();
    experiment.runs.resize(1);
    experiment.runs[0].readings.clear();
    for (const double value : values)
      experiment.runs[0].readings.push_back(
          {static_cast<double>(experiment.runs[0].readings.size()), 0.3, 0, value, 8, {0, 0}});
    const Measurements measurements(experiment);
    REQUIRE(measurements.series().front().channel.label() == "Fx");
    return measurements.series().front().step;
  };
  for (const double step : {0.03, 0.5, std::numbers::pi / 180}) {
    CAPTURE(step);
    std::vector<double> values, finer, few;
    for (const int multiple : {0, 14, 33, 57, 77, 111, 140, 161, 180, 175})
      values.push_back(7.1 + step * multiple);
    CHECK(step_of(values) == close_to(step / 0.4).epsilon(1e-6));
    finer = values;
    finer[4] += step / 4;
    CHECK(step_of(finer) == close_to(step / 4 / 0.4).epsilon(1e-6));
    finer[5] += step / std::numbers::e * 1e-3;
    CHECK(step_of(finer) < 1e-3 * step / 0.4);
    few.assign(values.begin(), values.begin() + 8);
    CHECK(step_of(few) == 0);  // seven differences may have a larger divisor by chance
  }
  CHECK(step_of({1, 1, 1, 1, 1}) == 0);
  CHECK(step_of({1, 1, 3, 3, 3}) == close_to(2 / 0.4));  // few differences, but coarse ones repeat
}

TEST_CASE("a residual is measured less predicted, in declared sigmas of its channel") {
  const Experiment experiment = two_runs();
  const Measurements measurements(experiment);
  Prediction predicted;
  predicted.runs = {Trace(2, 6), Trace(1, 6)};
  predicted.runs[0] << 0.3, 0, 3, 6, 0.5, 1, 0.2, 0, 7, 12, 2, 9;  // x y Fx Fy q1 q2
  predicted.runs[1] << 0.5, 1, -5, 0, 0, 0;
  const std::vector<double> expected{(4 - 3) / 0.4,  (8 - 6) / 0.8,  (16 - 12) / 0.8, (1 - 0.5) / 0.05,
                                     (3 - 2) / 0.05, (2 - 1) / 0.05, (1 - 0.5) / 0.1, (2 - 1) / 0.2};
  const std::vector<double> residual = measurements.residual(experiment, predicted);
  REQUIRE(residual.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(residual[i] == close_to(expected[i]));
}
