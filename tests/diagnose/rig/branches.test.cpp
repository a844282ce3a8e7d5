#include "diagnose/rig/branches.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "diagnose/answers/diagnosis.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// A straight column under a force along it, up to twice where it buckles or so, and a bent chain pressed.
Experiment column() {
  Experiment experiment = three_links();
  load(experiment, {0, 0, 0}, {0, 0}, {-3.2, 0}, 30);
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0.02}, 25, true);
  return experiment;
}

/// Rest angles with errors of some thousandths of a radian; the opposite sign moves the column to the other
/// branch.
std::vector<double> leaning(double sign) {
  return {sign * 2e-3, -sign * 1.5e-3, sign * 1e-3};
}

double mean_square(const Study& study, const Prediction& predicted) {
  return study.residual(predicted).squaredNorm() / static_cast<double>(study.measurements().size());
}

/// How far beside its line the column's end lies at the last reading.
double beside(const Study& study) {
  return study.nominal().runs[0](30, column_y);
}

}  // namespace

TEST_CASE("a straight column buckles to the branch of its readings") {
  for (const double sign : {1.0, -1.0}) {
    const Experiment read = measured(column(), only("rest_spread"), leaning(sign), 3);
    CHECK_FALSE(Study(read).nominal().reached);
    const Study study(on_observed_branches(Study(read)));
    REQUIRE(study.nominal().reached);
    CHECK(std::signbit(beside(study)) == std::signbit(read.runs[0].readings.back()[column_y]));
    CHECK(std::abs(beside(study)) > 0.3);
    REQUIRE(study.experiment().runs[0].branch);
    // The nominal model of the bent chain is on the branch of the readings.
    CHECK_FALSE(study.experiment().runs[1].branch);
  }
}

TEST_CASE("a diagnosis names the run on another branch, and finds what bends the column" *
          doctest::test_suite("long")) {
  const Study study(on_observed_branches(Study(measured(column(), only("rest_spread"), leaning(-1), 3))));
  const Diagnosis diagnosis = diagnose::diagnose(study);
  REQUIRE(diagnosis.gap.other_branch.size() == 1);
  CHECK(diagnosis.gap.other_branch[0].run == "load-1");
  CHECK(diagnosis.gap.other_branch[0].reading == study.experiment().runs[0].branch->first());
  REQUIRE(diagnosis.cause.verdict != CauseVerdict::unknown);
  CHECK(diagnosis.cause.ranking.front().cause == only("rest_spread"));
}

TEST_CASE("an explanation on the observed branch explains the readings by itself") {
  // Softer, it buckles before the nominal column does; stiffer, after it.
  for (const double sign : {1.0, -1.0})
    for (const double change : {-0.3, 0.0, 0.2}) {
      CAPTURE(sign);
      CAPTURE(change);
      const Candidate truth{{"rest_spread", {"joint_stiffness", 2}}};
      std::vector<double> values = leaning(sign);
      values.push_back(change);
      const Experiment read = measured(column(), truth, values, 4);
      const Study by_itself(read), study(on_observed_branches(Study(read)));
      REQUIRE(study.experiment().runs[0].branch);
      const double expected = mean_square(by_itself, predict(by_itself, truth, values));
      CHECK(mean_square(study, predict(study, truth, values)) == doctest::Approx(expected).epsilon(1e-6));
    }
}

TEST_CASE("a softer straight column without imperfection follows the branch of the readings") {
  std::vector<double> values = leaning(-1);
  values.push_back(-0.3);
  const Candidate truth{{"rest_spread", {"joint_stiffness", 2}}}, softer = only("joint_stiffness", 2);
  const Experiment read = measured(column(), truth, values, 5);
  const Study study(on_observed_branches(Study(read)));
  const Prediction without = predict(study, softer, {-0.3});
  REQUIRE(without.reached);
  CHECK(without.runs[0](30, column_y) ==
        doctest::Approx(read.runs[0].readings.back()[column_y]).epsilon(0.02));
}

TEST_CASE("a column held by friction between its branches stays there") {
  const Candidate truth{{"joint_friction", "rest_spread"}};
  std::vector<double> values{0.01};
  for (const double off : leaning(-1)) values.push_back(off);
  const Experiment read = measured(column(), truth, values, 8);
  REQUIRE(std::abs(read.runs[0].readings.back()[column_y]) < 0.01);
  const Study by_itself(read), study(on_observed_branches(Study(read)));
  REQUIRE(study.experiment().runs[0].branch);
  const double expected = mean_square(by_itself, predict(by_itself, truth, values));
  CHECK(mean_square(study, predict(study, truth, values)) == doctest::Approx(expected));
}

TEST_CASE("a nearly symmetric chain on the other branch shows no gap there") {
  // Pressing brings the chain near a bifurcation, where two thousandths of a radian decide the branch.
  Experiment experiment;
  experiment.name = "w";
  experiment.link_length = std::vector(5, 0.2844);
  experiment.joint_stiffness = {0, 0.442, 0.367, 0.307, 0.381};
  experiment.link_mass = std::vector(5, 0.0);
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::horizontal, {0, 0}, true};
  experiment.noise = {1.92e-4, 1.92e-4, 8.82e-4, 8.82e-4, 7.62e-4};
  press(experiment, {0.2103, -0.5765, 0.3667, 0.3347, -0.5878}, {-0.167, 0.0839}, 14, true);
  const Study nominal(experiment);
  Experiment imperfect = experiment;
  imperfect.runs[0].rest[3] += 0.002;
  const Prediction across = Study(imperfect).nominal();
  REQUIRE(across.reached);
  REQUIRE((across.runs[0].row(14) - nominal.nominal().runs[0].row(14)).abs().maxCoeff() > 0.5);
  // The equilibrium of the nominal chain itself on that side is what is read.
  Experiment there = experiment;
  for (Run& run : there.runs)
    for (std::size_t i = 0; i < run.readings.size(); ++i)
      for (std::size_t j = 0; j < run.rest.size(); ++j)
        run.readings[i][column_q + j] = angle(across.runs[0], static_cast<Eigen::Index>(i), j);
  for (std::size_t i = 0; i < there.runs[0].readings.size(); ++i) {
    there.runs[0].readings[i][column_Fx] = across.runs[0](static_cast<Eigen::Index>(i), column_Fx);
    there.runs[0].readings[i][column_Fy] = across.runs[0](static_cast<Eigen::Index>(i), column_Fy);
  }
  const Study found(on_observed_branches(Study(there)));
  REQUIRE(found.experiment().runs[0].branch);
  const Experiment read = [&] {
    Experiment on_side = experiment;
    on_side.runs[0].branch = found.experiment().runs[0].branch;
    return measured(on_side, {}, {}, 6);
  }();
  Experiment bare = read;
  bare.runs[0].branch.reset();
  CHECK(mean_square(Study(bare), Study(bare).nominal()) > 100);
  const Study study(on_observed_branches(Study(bare)));
  REQUIRE(study.experiment().runs[0].branch);
  CHECK(study.experiment().runs[0].branch->first() == 2);
  const auto values = static_cast<double>(study.measurements().size());
  CHECK(mean_square(study, study.nominal()) < 1 + 5 * std::sqrt(2 / values));
}

TEST_CASE("readings moved by an effect do not select a branch") {
  for (const EffectAt& at :
       {EffectAt("joint_friction"), EffectAt("stiffness_scale"), EffectAt("force_gain")}) {
    CAPTURE(at.label());
    const Study plain(full_bench());
    std::vector<double> much;
    for (const ParameterRange& range : plain.ranges(at)) much.push_back(range.scale);
    for (const Run& run : on_observed_branches(Study(measured(full_bench(), {{at}}, much, 7))).runs)
      CHECK_FALSE(run.branch);
  }
}
