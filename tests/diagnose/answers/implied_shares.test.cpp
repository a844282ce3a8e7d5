#include "diagnose/answers/implied_shares.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/discrepancy/torque_balance.hpp"
#include "diagnose/discrepancy/unknown_torque.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Presses from three shapes, without joint angles.
Experiment presses_without_angles() {
  Experiment experiment = three_links();
  experiment.noise[Channel::Name::q] = 0;
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.05, 0.03}, 25, true);
  press(experiment, {0.5, -0.3, 0.4}, {-0.05, -0.02}, 25, false);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.value.resize(column_q);
  return experiment;
}

RankedCause explained(const Candidate& candidate, const std::vector<double>& parameters, double probability) {
  RankedCause cause{};
  cause.hypothesis.candidate = cause.cause = candidate;
  cause.hypothesis.parameters = parameters;
  cause.probability = probability;
  return cause;
}

}  // namespace

TEST_CASE("an unknown torque is most probable at the joint where the torque is missing") {
  const std::vector<std::pair<EffectAt, std::vector<double>>> planted{
      {{"joint_stiffness", 1}, {0.3}}, {{"backlash", 2}, {0.03}}, {{"joint_stop", 3}, {0.05, 3}}};
  for (const auto& [at, parameters] : planted) {
    CAPTURE(at.label());
    const Study study(measured(presses_without_angles(), {{at}}, parameters, 7));
    const std::vector<JointShare> shares = shares_by_unknown_torques(study, search(study));
    REQUIRE(shares.size() == 3);
    CHECK(shares.front().joint == at.joint);
    CHECK(shares.front().share > 0.9);
  }
}

TEST_CASE("joints share by the evidence of an unknown torque at each alone") {
  const Study study(measured(presses_without_angles(), {}, {}, 9));
  Findings findings;
  findings.outside = unknown_torques(study);
  const auto add = [&](const Candidate& candidate, double log_evidence) {
    Hypothesis& one = findings.hypotheses.emplace_back();
    one.candidate = candidate;
    one.log_evidence = log_evidence;
  };
  const Effect &small = findings.outside->front(), &large = findings.outside->back();
  // ordered by their evidence
  add({{{small, 3}, {"gravity"}}}, -900);
  add(only("gravity"), -950);
  add({{{small, 3}}}, -1000);
  add({{{small, 1}}}, -1000 - std::log(4));
  add({{{large, 1}}}, -1000 - std::log(4));
  const std::vector<JointShare> shares = shares_by_unknown_torques(study, findings);
  REQUIRE(shares.size() == 3);
  CHECK((shares[0].joint == 3 && shares[0].share == close_to(1 / 1.5)));
  CHECK((shares[1].joint == 1 && shares[1].share == close_to(0.5 / 1.5)));
  CHECK((shares[2].joint == 2 && shares[2].share == 0.0));
}

TEST_CASE("a stiffer spring implies that torque is missing at its joint and nowhere else") {
  // The statics of the true rig are k_i d_i = [J^T F]_i but for k_2 (1 + a) d_2, so the nominal ones miss
  // a k_2 d_2 at joint 2 and nothing elsewhere.
  const Study study(measured(presses_without_angles(), {{{"joint_stiffness", 2}}}, {0.3}, 8));
  const std::vector<JointShare> shares =
      shares_by_causes(study, {explained(only("joint_stiffness", 2), {0.3}, 1)});
  CHECK(shares.front().joint == 2);
  // What is left elsewhere is the solver's tolerance, squared.
  CHECK(shares.front().share == close_to(1).epsilon(1e-9));
}

TEST_CASE("causes share the joints by their probability, however large the torques that they imply") {
  const Study study(measured(presses_without_angles(), {}, {}, 9));
  const std::vector<JointShare> shares =
      shares_by_causes(study, {explained(only("joint_stiffness", 1), {0.4}, 0.25),
                               explained(only("joint_stiffness", 3), {0.02}, 0.75)});
  REQUIRE(shares.size() >= 2);
  CHECK(shares[0].joint == 3);
  // the solver's tolerance in what is small elsewhere
  CHECK(shares[0].share == close_to(0.75).epsilon(1e-6));
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
