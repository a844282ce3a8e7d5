/// Instruments of the wider catalogue, and runs that differ.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/inference/study.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

Prediction predicted(const Experiment& experiment, const Candidate& candidate,
                     const std::vector<double>& value) {
  Prediction prediction = predict(Study(experiment), candidate, value, true);
  REQUIRE(prediction.reached);
  return prediction;
}

/// Three presses that differ.
Experiment presses() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 8, true);
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0.02}, 8, true);
  press(experiment, {-0.2, 0.5, 0.4}, {-0.04, 0}, 8, false);
  return experiment;
}

bool offered(const Experiment& experiment, const char* id) {
  const std::vector<EffectAt> possible = possible_effects(Study(experiment));
  return std::find(possible.begin(), possible.end(), EffectAt(id)) != possible.end();
}

}  // namespace

TEST_CASE("a tare error of one run changes that run alone") {
  const Experiment experiment = presses();
  const Prediction nominal = predicted(experiment, {}, {});
  const Prediction tared = predicted(experiment, only("run_tare"), {0, 0, 0.3, -0.2, 0, 0});
  for (const std::size_t r : {0U, 2U}) CHECK(difference(tared.runs[r], nominal.runs[r]) == 0);
  CHECK(difference(tared.runs[1].col(column_Fx), nominal.runs[1].col(column_Fx) + 0.3) < 1e-12);
  CHECK(difference(tared.runs[1].col(column_Fy), nominal.runs[1].col(column_Fy) - 0.2) < 1e-12);
  CHECK(tared.sensitivity[2][0].abs().maxCoeff() == 0);
  CHECK(tared.sensitivity[2][1].col(column_Fx).minCoeff() == close_to(1));
  CHECK(difference(predicted(experiment, only("run_tare"), {0.3, -0.2, 0.3, -0.2, 0.3, -0.2}).runs[2],
                   predicted(experiment, only("force_bias"), {0.3, -0.2}).runs[2]) == 0);
}

TEST_CASE("values of a run do not depend on the selection of runs") {
  const Experiment experiment = presses();
  const std::vector<double> tare{0, 0, 0, 0, 0.3, -0.2};
  Experiment last = Study(experiment).experiment();
  last.runs.erase(last.runs.begin(), last.runs.begin() + 2);
  const Study study(last);
  REQUIRE(study.ranges(EffectAt("run_tare")).size() == tare.size());
  CHECK(difference(predict(study, only("run_tare"), tare).runs[0],
                   predicted(experiment, only("run_tare"), tare).runs[2]) == 0);
}

TEST_CASE("rest angles of one run are those of rest_spread in that run") {
  const Experiment experiment = presses();
  const Prediction nominal = predicted(experiment, {}, {});
  const Prediction other = predicted(experiment, only("run_rest"), {0, 0, 0, 0.02, -0.01, 0.03, 0, 0, 0});
  const Prediction everywhere = predicted(experiment, only("rest_spread"), {0.02, -0.01, 0.03});
  CHECK(difference(other.runs[0], nominal.runs[0]) == 0);
  CHECK(difference(other.runs[1], everywhere.runs[1]) == 0);
  CHECK(difference(other.runs[1], nominal.runs[1]) > 1e-3);
}

TEST_CASE("cross-talk acts on readings and on imposed forces") {
  Experiment experiment = presses();
  const Trace nominal = predicted(experiment, {}, {}).runs[0];
  const Trace read = predicted(experiment, only("cross_talk"), {0.05, -0.02}).runs[0];
  CHECK(difference(read.col(column_Fx), nominal.col(column_Fx) + 0.05 * nominal.col(column_Fy)) < 1e-12);
  CHECK(difference(read.col(column_Fy), nominal.col(column_Fy) - 0.02 * nominal.col(column_Fx)) < 1e-12);

  // The cell shows what is commanded where the true force is (1 + C)^-1 of it.
  experiment.runs.clear();
  load(experiment, {0.2, 0.3, -0.3}, {-1, 0.5}, {-1, 0.5}, 1);
  Experiment turned = experiment;
  const double determinant = 1 + 0.05 * 0.02;
  for (Reading& one : turned.runs[0].readings) {
    one[column_Fx] = (-1 - 0.05 * 0.5) / determinant;
    one[column_Fy] = (0.5 + 0.02 * -1) / determinant;
  }
  const auto q = [](const Prediction& of) { return of.runs[0].rightCols(3); };
  CHECK(difference(q(predicted(experiment, only("cross_talk"), {0.05, -0.02})),
                   q(predicted(turned, {}, {}))) < 1e-9);
  CHECK(offered(experiment, "cross_talk"));
  for (Reading& one : experiment.runs[0].readings) one[column_Fy] = 0;  // as a misaligned rail's
  CHECK_FALSE(offered(experiment, "cross_talk"));
}

TEST_CASE("a nonlinear cell reads F + c F^2 of each component, also under a servo") {
  Experiment experiment = presses();
  const Trace nominal = predicted(experiment, {}, {}).runs[0];
  const Trace read = predicted(experiment, only("cell_curvature"), {0.02, -0.01}).runs[0];
  CHECK(difference(read.col(column_Fx), nominal.col(column_Fx) + 0.02 * nominal.col(column_Fx).square()) <
        1e-12);
  CHECK(difference(read.col(column_Fy), nominal.col(column_Fy) - 0.01 * nominal.col(column_Fy).square()) <
        1e-12);

  // The reading of (-1.25, 0.75) is -1.25 + 0.2 * 1.5625 and 0.75 - 0.4 * 0.5625.
  experiment.runs.clear();
  load(experiment, {0.2, 0.3, -0.3}, {-0.9375, 0.525}, {-0.9375, 0.525}, 1);
  Experiment bent = experiment;
  for (Reading& one : bent.runs[0].readings) one[column_Fx] = -1.25, one[column_Fy] = 0.75;
  const auto q = [](const Prediction& of) { return of.runs[0].rightCols(3); };
  CHECK(difference(q(predicted(experiment, only("cell_curvature"), {0.2, -0.4})),
                   q(predicted(bent, {}, {}))) < 1e-9);
}

TEST_CASE("a nonlinear cell is identified, and not confused with bias, gain or stiffness" *
          doctest::test_suite("long")) {
  Experiment experiment = presses();
  const Experiment planted = measured(experiment, only("cell_curvature"), {0.03, 0.01}, 4);
  const Diagnosis diagnosis = diagnose::diagnose(Study(planted));
  REQUIRE(diagnosis.cause.verdict == CauseVerdict::identified);
  const Hypothesis& best = diagnosis.cause.ranking.front().hypothesis;
  CHECK(diagnosis.cause.ranking.front().cause.label() == "cell_curvature");
  CHECK(best.parameters[0] == doctest::Approx(0.03).epsilon(0.2));
  for (const char* other : {"force_gain", "asymmetric_spring"}) {
    const Study study(measured(experiment, only(other), {0.1}, 5));
    const Diagnosis of_other = diagnose::diagnose(study);
    CHECK(of_other.cause.ranking.front().cause.label() != "cell_curvature");
  }
}

namespace {

/// A press within a microsecond, and its place held for ten seconds.
Experiment pressed_and_held() {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 1, false, 1e-6);
  Run& run = experiment.runs[0];
  for (int i = 1; i <= 20; ++i) {
    run.readings.push_back(run.readings[1]);
    run.readings.back().t = 1e-6 + 0.5 * i;
  }
  return experiment;
}

}  // namespace

TEST_CASE("a saturated cell reads its limit, and is considered where readings form a plateau") {
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  const Trace nominal = predicted(experiment, {}, {}).runs[0];
  const double limit = 0.6 * nominal.col(column_Fx).abs().maxCoeff();
  const Trace shown = predicted(experiment, only("saturation"), {1 / limit}).runs[0];
  for (const ChannelColumn column : {column_Fx, column_Fy})
    CHECK(difference(shown.col(column), nominal.col(column).min(limit).max(-limit)) < 1e-12);
  CHECK(offered(measured(experiment, only("saturation"), {1 / limit}, 4), "saturation"));
  CHECK_FALSE(offered(measured(experiment, {}, {}, 4), "saturation"));
}

TEST_CASE("a lagging cell approaches a constant force as 1 - exp(-t / tau)") {
  const Experiment experiment = pressed_and_held();
  const double force = predicted(experiment, {}, {}).runs[0](1, column_Fx), tau = 2;
  const Trace shown = predicted(experiment, only("sensor_lag"), {tau}).runs[0];
  for (Eigen::Index row = 1; row < shown.rows(); ++row) {
    const double held = 0.5 * static_cast<double>(row - 1);
    CHECK(shown(row, column_Fx) ==
          doctest::Approx((1 - std::exp(-held / tau)) * force).epsilon(1e-5).scale(1));
  }
}

TEST_CASE("a creeping cell shows a share more of a constant force as 1 - exp(-t / tau)") {
  const Experiment experiment = pressed_and_held();
  const double force = predicted(experiment, {}, {}).runs[0](1, column_Fx), share = 0.1, tau = 2;
  const Trace shown = predicted(experiment, only("sensor_creep"), {share, std::log(tau)}).runs[0];
  for (Eigen::Index row = 1; row < shown.rows(); ++row) {
    const double held = 0.5 * static_cast<double>(row - 1);
    // The load takes 1e-6 s to come.
    CHECK(shown(row, column_Fx) ==
          doctest::Approx((1 + share * (1 - std::exp(-held / tau))) * force).epsilon(1e-5));
  }
}

TEST_CASE("a lagging cell trails a ramp by lag times rate") {
  // The straight side of a small press: forces go nearly in proportion to the way.
  Experiment experiment = three_links();
  press(experiment, {0.3, -0.5, 0.4}, {-1e-4, 0}, 40, false, 2);
  const Trace nominal = predicted(experiment, {}, {}).runs[0];
  const Trace shown = predicted(experiment, only("sensor_lag"), {3.0}).runs[0];
  const double rate = (nominal(40, column_Fx) - nominal(39, column_Fx)) / 2;
  CHECK(nominal(40, column_Fx) - shown(40, column_Fx) == close_to(3.0 * rate).epsilon(1e-3));
}

TEST_CASE("effects that one run, one component or a counted clock cannot show are not considered") {
  Experiment experiment = presses();
  CHECK(offered(experiment, "run_tare"));
  CHECK(offered(experiment, "run_rest"));
  CHECK(offered(experiment, "cross_talk"));
  CHECK(offered(experiment, "hysteresis"));
  Experiment one = experiment;
  one.runs.resize(1);
  CHECK_FALSE(offered(one, "run_tare"));
  CHECK_FALSE(offered(one, "run_rest"));
  Experiment along = experiment;
  for (Run& run : along.runs)
    for (Reading& reading : run.readings) reading[column_Fy] = nan_value();
  CHECK_FALSE(offered(along, "cross_talk"));
  Experiment forth = experiment;
  forth.runs.erase(forth.runs.begin(), forth.runs.begin() + 2);
  for (const char* id : {"hysteresis", "load_friction", "plastic_set"}) CHECK_FALSE(offered(forth, id));
  Experiment counted = experiment;
  for (Run& run : counted.runs)
    for (std::size_t i = 0; i < run.readings.size(); ++i) run.readings[i].t = static_cast<double>(i);
  for (const char* id : {"sensor_lag", "relaxation_spectrum"}) CHECK_FALSE(offered(counted, id));
}
