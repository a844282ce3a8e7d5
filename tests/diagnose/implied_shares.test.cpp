#include "diagnose/answers/implied_shares.hpp"

#include <doctest/doctest.h>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Presses from three shapes, without joint angles.
Experiment presses_without_angles() {
  Experiment experiment = three_links();
  experiment.noise.q = 0;
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 25, true);
  press(experiment, {0.5, -0.3, 0.4}, {-0.05, -0.02}, 25, false);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.q.clear();
  return experiment;
}

std::size_t named_joint(const EffectAt& at, const std::vector<double>& parameters) {
  const Experiment experiment = measured(presses_without_angles(), {{at}}, parameters, 7);
  const Measurements measurements(experiment);
  const std::vector<double> residual = measurements.residual(experiment, predict(Study(experiment), {}, {}));
  return shares_by_torque_law(Study(experiment), residual, NoiseModel()).front().joint;
}

}  // namespace

TEST_CASE("the best torque law sits at the joint where the torque is missing") {
  for (const std::size_t joint : {1, 2, 3}) {
    CHECK(named_joint({"joint_stiffness", joint}, {0.3}) == joint);
    CHECK(named_joint({"backlash", joint}, {0.03}) == joint);
    CHECK(named_joint({"joint_stop", joint}, {0.05, 3}) == joint);
  }
}

TEST_CASE("a stiffer spring implies that torque is missing at its joint and nowhere else") {
  // The statics of the true rig are k_i d_i = [J^T F]_i but for k_2 (1 + a) d_2, so the nominal ones miss
  // a k_2 d_2 at joint 2 and nothing elsewhere.
  const Experiment experiment = measured(presses_without_angles(), {{{"joint_stiffness", 2}}}, {0.3}, 8);
  const Fit found = fit(Study(experiment), {{{"joint_stiffness", 2}}}, {});
  const std::vector<JointShare> shares = shares_by_fits(Study(experiment), {found}, {1.0});
  CHECK(shares.front().joint == 2);
  // What is left elsewhere is the solver's tolerance, squared.
  CHECK(shares.front().share == close_to(1).epsilon(1e-9));
}
