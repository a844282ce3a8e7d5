#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/inference/study.hpp"
#include "diagnose/rig/history.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

Experiment short_press() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.04, 0.01}, 6, true);
  return experiment;
}

/// The derivative beside the nominal rig of a change that it does not have, against two predictions.
void check_beside(const char* what, const Rig& changed, double step) {
  CAPTURE(what);
  const Experiment experiment = short_press();
  const Rig nominal = Study(experiment).nominal_rig();
  const Prediction beside = simulate(experiment, nominal, {{changed, step}});
  const Prediction other = simulate(experiment, changed, {});
  REQUIRE(beside.reached);
  REQUIRE(other.reached);
  const Trace quotient = (other.runs[0] - beside.runs[0]) / step;
  // One chord step leaves the square of what changes, a share of `step` of it: forces are of some newtons.
  const double largest = quotient.abs().maxCoeff();
  CHECK(largest > 0);
  CHECK(difference(beside.sensitivity[0][0], quotient) <= 1e-3 * largest);
}

}  // namespace

TEST_CASE("variations may add what the rig lacks: coupled joints, friction") {
  const Rig nominal = Study(short_press()).nominal_rig();
  Rig coupled = nominal;
  coupled.coupling = 1e-5;
  check_beside("coupling", coupled, 1e-5);
  Rig dry = nominal;
  dry.friction.assign(3, 1e-5);
  check_beside("friction", dry, 1e-5);
  Rig stiffer = nominal;
  stiffer.stiffness[1] += 1e-5;
  check_beside("stiffness", stiffer, 1e-5);
}

TEST_CASE("a zero variation has no derivative; several keep their order") {
  const Experiment experiment = short_press();
  const Rig nominal = Study(experiment).nominal_rig();
  Rig stiffer = nominal, biased = nominal;
  stiffer.stiffness[0] += 1e-6;
  biased.force_bias = {1e-6, 0, 0};
  const Prediction all = simulate(experiment, nominal, {{stiffer, 1e-6}, {nominal, 1e-6}, {biased, 1e-6}});
  REQUIRE(all.sensitivity.size() == 3);
  CHECK(all.sensitivity[1][0].abs().maxCoeff() == 0);
  const Trace& bias = all.sensitivity[2][0];
  for (Eigen::Index i = 0; i < bias.rows(); ++i) {
    CHECK(std::abs(bias(i, column_Fx) - 1) < 1e-6);  // rounding of forces of some newtons over a step of 1e-6
    CHECK(std::abs(bias(i, column_Fy)) < 1e-6);
  }
  CHECK(all.sensitivity[0][0].col(column_Fx).abs().maxCoeff() > 0.01);
}

TEST_CASE("a reading without a command is skipped, and the next continues from the last") {
  Experiment experiment = short_press();
  const Rig nominal = Study(experiment).nominal_rig();
  const Prediction whole = simulate(experiment, nominal, {});
  experiment.runs[0].readings[3][column_x] = std::nan("");
  Rig stiffer = nominal;
  stiffer.stiffness[0] += 1e-6;
  const Prediction holed = simulate(experiment, nominal, {{stiffer, 1e-6}});
  REQUIRE(holed.reached);
  CHECK(holed.runs[0].row(3).isNaN().all());
  CHECK((holed.sensitivity[0][0].row(3) == 0).all());
  for (const Eigen::Index i : {2, 4, 12})
    for (Eigen::Index c = 0; c < whole.runs[0].cols(); ++c)
      CHECK(holed.runs[0](i, c) == doctest::Approx(whole.runs[0](i, c)).epsilon(1e-8));
}

TEST_CASE(
    "variables of a correction: readings, time, number of the run from 1, direction; angle and deflection") {
  Eigen::ArrayXd row(9);
  row << 1, 2, 3, 4, 5, 6, 0.25, 0.5, 0.75;
  using Values = std::vector<double>;
  CHECK(reading_values(row, {7, 2, -1, 0}, Channel(Channel::Name::Fx)) == Values{1, 2, 3, 4, 7, 3, -1});
  CHECK(reading_values(row, {7, 0, 1, 0.125}, Channel(Channel::Name::q, 1)) ==
        Values{1, 2, 3, 4, 7, 1, 1, 0.5, 0.375});
}
