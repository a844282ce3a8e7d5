#include "diagnose/discrepancy/implied_shares.hpp"

#include <doctest/doctest.h>

#include "diagnose/discrepancy/torque_balance.hpp"
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

TEST_CASE("explanations share the joints by their probability, however large the torques that they imply") {
  const Experiment experiment = measured(presses_without_angles(), {}, {}, 9);
  const Study study(experiment);
  const auto explained = [](std::size_t joint, double value) {
    Fit fit;
    fit.candidate = {{{"joint_stiffness", joint}}};
    fit.parameters = {value};
    return fit;
  };
  const std::vector<JointShare> shares =
      shares_by_fits(study, {explained(1, 0.4), explained(3, 0.02)}, {0.25, 0.75});
  REQUIRE(shares.size() >= 2);
  CHECK(shares[0].joint == 3);
  CHECK(shares[0].share ==
        close_to(0.75).epsilon(1e-6));  // the solver's tolerance in what is small elsewhere
  CHECK(shares[1].joint == 1);
  CHECK(shares[1].share == close_to(0.25).epsilon(1e-6));
}

TEST_CASE("what the nominal model's own effects carry is not missing") {
  Experiment experiment = full_bench();
  experiment.effects = {{"nonlinear_spring", 0, {{"c", 3.0}}}};
  const Study study(experiment);
  const Experiment ideal = as_measured(experiment, study.nominal());
  double carried = 0;
  for (const auto& joint : missing_torques(ideal))
    for (const MissingTorque& one : joint) carried = std::max(carried, std::abs(one.torque));
  CHECK(carried > 1e-3);
  const auto beyond = missing_torques(study, ideal);
  REQUIRE(beyond.size() == 3);
  for (const auto& joint : beyond) {
    REQUIRE_FALSE(joint.empty());
    for (const MissingTorque& one : joint) CHECK(std::abs(one.torque) < 1e-12);
  }
}
