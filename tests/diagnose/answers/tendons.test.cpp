/// \file
/// Diagnoses of a finger that a tendon bends.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/design/candidate_runs.hpp"
#include "diagnose/discrepancy/torque_balance.hpp"
#include "diagnose/report/view.hpp"
#include "tests/diagnose/finger.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// What is found in readings with noise under the planted cause.
Diagnosis diagnosis_of(const Candidate& truth, const std::vector<double>& parameters) {
  return diagnose::diagnose(Study(measured(finger(there_and_back(12, 20)), truth, parameters, 7)));
}

}  // namespace

TEST_CASE("what is wrong with a finger is found under its tendon") {
  struct Planted {
    Candidate cause;
    std::vector<double> parameters;
  };
  for (const Planted& one : {Planted{only("joint_stiffness", 2), {0.3}},
                             Planted{only("capstan_friction"), {0.08}}, Planted{only("moment_arm"), {0.2}}}) {
    INFO(one.cause.label());
    const Diagnosis found = diagnosis_of(one.cause, one.parameters);
    CHECK(found.gap.present);
    CHECK(found.cause.is_explained());
    const auto named = found.cause.ranking.begin() + static_cast<std::ptrdiff_t>(found.cause.named);
    CHECK(std::any_of(found.cause.ranking.begin(), named,
                      [&](const RankedCause& each) { return each.cause.is_form_of(one.cause); }));
  }
}

TEST_CASE("the tension is what a finger's curves are drawn over, and its range what is proposed") {
  const Experiment experiment = finger(there_and_back(12, 5));
  const Command command = command_of(experiment.runs[0]);
  CHECK(command.label == "tension, N");
  CHECK(command.along[5] == 12);
  CHECK(command.farthest == 5);
  const Study study(experiment);
  const std::vector<CandidateRun> proposed = candidate_runs(experiment, 2, operating_envelope(study));
  REQUIRE(proposed.size() == 4);  // there, and there and back, from the shape and from its mirror image
  CHECK(proposed[1].description == "tension from 0 to 12 N from the rest shape of bend and back");
  CHECK(proposed[1].run.turns_back());
  CHECK(proposed[0].run.readings.back().covariates[0] == 12);
}

TEST_CASE("at the angles of the equilibrium loads along a chain leave no torque missing") {
  Experiment experiment = finger(there_and_back(8, 4));
  for (Reading& reading : experiment.runs[0].readings)
    reading.covariates = {reading.covariates[0], 0.3, -0.1 * reading.covariates[0]};
  set_loads(experiment, {{Load::Kind::tendon, 0, finger_radius}, {Load::Kind::force, 1, {}, 1, 0.6}},
            {"tension", "Gx", "Gy"});
  const Study study(experiment);
  constexpr double solved = 1e-9;  // N m, of torques of a tenth
  for (const auto& of_joint : missing_torques(as_measured(experiment, study.nominal())))
    for (const MissingTorque& one : of_joint) CHECK(std::abs(one.torque) < solved);
}
