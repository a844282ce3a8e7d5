#include "diagnose/inference/fit.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>

#include "diagnose/decision/heldout.hpp"
#include "diagnose/inference/start.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

TEST_CASE("a fit finds every effect that was put in, within five of its standard deviations") {
  const Experiment bench = full_bench();
  for (const EffectAt& at : possible_effects(Study(bench))) {
    CAPTURE(at.effect->id);
    CAPTURE(at.joint);
    const std::vector<ParameterRange> ranges = Study(bench).ranges(at);
    std::vector<double> truth;
    for (const ParameterRange& range : ranges) truth.push_back(0.6 * range.scale);
    if (at.effect == &effect("joint_stop")) truth = {0.08, 2.0};
    if (const auto known = chosen(at); known && !known->sizeable.empty()) truth = known->sizeable;
    const Experiment experiment = measured(bench, {{at}}, truth, 7);
    const Measurements measurements(experiment);
    const Fit fitted = fit(Study(experiment), {{at}}, {});
    REQUIRE(fitted.converged);
    // The chi-square of N values scatters by sqrt(2 N).
    const double values = static_cast<double>(measurements.size());
    CHECK(fitted.cost < values + 5 * std::sqrt(2 * values));
    // Two arms, or two elements, may be one the other, and stand for a third.
    if (at.effect->id == "hysteresis" || at.effect->id == "relaxation_spectrum") continue;
    for (std::size_t p = 0; p < truth.size(); ++p) {
      const auto j = static_cast<Eigen::Index>(p);
      const double sigma = std::sqrt(fitted.covariance(j, j));
      INFO(p);
      CHECK(sigma > 0);
      CHECK(std::abs(fitted.parameters[p] - truth[p]) < 5 * sigma);
    }
  }
}

TEST_CASE("two percent of outliers move a fit by less than its bounds") {
  const std::vector<double> truth{0.12};
  const Experiment experiment = measured(full_bench(), only("joint_stiffness", 2), truth, 3, 50);
  const Measurements measurements(experiment);
  const Fit fitted = fit(Study(experiment), only("joint_stiffness", 2), {});
  REQUIRE(fitted.converged);
  CHECK(std::abs(fitted.parameters[0] - truth[0]) < 4 * std::sqrt(fitted.covariance(0, 0)));
}

TEST_CASE("a parameter that wants to go where it cannot stays at its bound and says so") {
  // Negative friction fits noise as well as none; a load cell that reads low cannot be friction at all.
  const Experiment experiment = measured(full_bench(), only("guide_friction"), {-0.2}, 5);
  const Measurements measurements(experiment);
  const Fit fitted = fit(Study(experiment), only("guide_friction"), {});
  REQUIRE(fitted.converged);
  CHECK(fitted.parameters[0] == doctest::Approx(0));
  CHECK(fitted.at_bound[0]);
  CHECK(fitted.covariance(0, 0) == 0);
}

TEST_CASE("what the runs never reach carries no information") {
  const Experiment experiment = measured(full_bench(), {}, {}, 11);
  const Measurements measurements(experiment);
  const Fit fitted = fit_from(Study(experiment), only("joint_stop", 1), {}, {2.5, 1.0});
  REQUIRE(fitted.converged);
  CHECK(fitted.information(0, 0) == 0);
  CHECK(fitted.information(1, 1) == 0);
}

TEST_CASE("profile bounds of a nearly linear parameter are 1.96 standard deviations") {
  const Experiment experiment = measured(full_bench(), only("force_gain"), {0.05}, 13);
  const Measurements measurements(experiment);
  const Fit fitted = fit(Study(experiment), only("force_gain"), {});
  const double sigma = std::sqrt(fitted.covariance(0, 0));
  const Profile bounds = profile(Study(experiment), fitted, 0, {}, 1.96 * 1.96);
  // Huber's loss is flatter than the square for three readings in a thousand.
  CHECK(fitted.parameters[0] - bounds.low == close_to(1.96 * sigma).epsilon(0.01));
  CHECK(bounds.high - fitted.parameters[0] == close_to(1.96 * sigma).epsilon(0.01));
}

TEST_CASE("profile bounds hold the others free: friction beside a stiffness error") {
  const Candidate both{{{"joint_friction"}, {"joint_stiffness", 1}}};
  const Experiment experiment = measured(full_bench(), both, {0.01, 0.1}, 17);
  const Measurements measurements(experiment);
  const Fit alone = fit(Study(experiment), only("joint_stiffness", 1), {});
  const Fit fitted = fit(Study(experiment), both, {});
  REQUIRE(fitted.converged);
  CHECK(fitted.cost < alone.cost);
  for (std::size_t p : {0U, 1U}) {
    const Profile bounds = profile(Study(experiment), fitted, p, {}, 16);  // four standard deviations
    const double truth = p == 0 ? 0.01 : 0.1;
    CHECK(bounds.low < truth);
    CHECK(bounds.high > truth);
  }
}

TEST_CASE("in noise three times as wide everything is known a third as well, in the same place") {
  const Experiment experiment = measured(full_bench(), only("rest_angle", 1), {0.03}, 19);
  const Fit fitted = fit(Study(experiment), only("rest_angle", 1), {});
  NoiseModel wide;
  wide.scale.fill(3);
  const Fit same = in_noise(Study(experiment), fitted, wide);
  CHECK(same.parameters == fitted.parameters);
  CHECK(same.residual == fitted.residual);
  CHECK(same.noise == wide);
  CHECK(same.information(0, 0) == close_to(fitted.information(0, 0) / 9));
  CHECK(same.covariance(0, 0) == close_to(9 * fitted.covariance(0, 0)));
  for (std::size_t i = 0; i < same.whitened.size(); ++i)
    CHECK(same.whitened[i] == close_to(fitted.whitened[i] / 3));
}

TEST_CASE("what held-out values are makes no difference to a fit, nor to where it starts from") {
  // effects whose ranges do not follow the forces that are measured, and which start in several places
  for (const char* id : {"nonlinear_spring", "viscoelasticity"}) {
    CAPTURE(id);
    const Candidate truth = only(id);
    std::vector<double> sizeable;
    for (const ParameterRange& range : Study(full_bench()).ranges(truth))
      sizeable.push_back(0.6 * range.scale);
    if (const auto known = chosen(truth.effects[0]); known && !known->sizeable.empty())
      sizeable = known->sizeable;
    const Experiment clean = measured(full_bench(), truth, sizeable, 23);
    HeldOut first = nothing_held(clean);
    first.reading[0].assign(clean.runs[0].readings.size(), true);
    const Fit expected = fit(Study(without(clean, first)), truth, {});
    REQUIRE(expected.converged);
    for (const double off : {-50.0, 50.0}) {
      Experiment other = clean;
      std::vector<Reading>& readings = other.runs[0].readings;
      for (std::size_t i = 0; i < readings.size(); ++i) {
        readings[i].Fx += off;
        readings[i].Fy += i > readings.size() / 2 ? -off : off;
      }
      CHECK(fit(Study(without(other, first)), truth, {}).parameters == expected.parameters);
    }
  }
}

TEST_CASE("starts lie within the physical bounds") {
  const Experiment experiment = full_bench();
  for (const EffectAt& at : possible_effects(Study(experiment))) {
    const std::vector<ParameterRange> ranges = Study(experiment).ranges(at);
    const InitialGuesses known = initial_guesses(Study(experiment), at);
    REQUIRE_FALSE(known.points.empty());
    for (const std::vector<double>& start : known.points) {
      REQUIRE(start.size() == ranges.size());
      for (std::size_t p = 0; p < start.size(); ++p) {
        CHECK(start[p] >= ranges[p].low);
        CHECK(start[p] <= ranges[p].high);
      }
    }
  }
}

TEST_CASE("Huber's loss: the square up to the bound, then the line that goes on from it") {
  CHECK(huber(2, 3) == 4);
  CHECK(huber(-3, 3) == 9);
  CHECK(huber(5, 3) == 21);  // 9 + 2 * 3 * (5 - 3)
  CHECK(huber(-5, 3) == 21);
}

TEST_CASE("a parameter that wants beyond its upper bound stays there and says so") {
  const double high = Study(full_bench()).ranges(only("force_gain"))[0].high;
  const Experiment experiment = measured(full_bench(), only("force_gain"), {1.3 * high}, 5);
  const Measurements measurements(experiment);
  const Fit fitted = fit(Study(experiment), only("force_gain"), {});
  REQUIRE(fitted.converged);
  CHECK(fitted.parameters[0] == close_to(high));
  CHECK(fitted.at_bound[0]);
  CHECK(fitted.covariance(0, 0) == 0);
}

TEST_CASE("the covariance is the inverse of J'J over the values that are no outliers, correlation included") {
  const Candidate both{{{"rest_angle", 1}, {"rest_angle", 2}}};
  const Experiment experiment = measured(full_bench(), both, {0.02, -0.01}, 23, 12);
  const Measurements measurements(experiment);
  const Fit fitted = fit_from(Study(experiment), both, {}, {0, 0});
  REQUIRE(fitted.converged);
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  int gross = 0;
  for (Eigen::Index i = 0; i < fitted.jacobian.rows(); ++i) {
    if (std::abs(fitted.whitened[static_cast<std::size_t>(i)]) > FitSettings().outlier_bound) {
      ++gross;
      continue;
    }
    information += fitted.jacobian.row(i).transpose() * fitted.jacobian.row(i);
  }
  CHECK(gross > 20);
  const Eigen::Matrix2d expected = information.inverse();
  for (Eigen::Index i = 0; i < 2; ++i) {
    CHECK(fitted.information(i, i) / information(i, i) == close_to(1));
    for (Eigen::Index j = 0; j < 2; ++j) CHECK(fitted.covariance(i, j) / expected(i, j) == close_to(1));
  }
  // two rest angles of one chain are hard to tell apart
  CHECK(std::abs(expected(0, 1)) > 0.3 * std::sqrt(expected(0, 0) * expected(1, 1)));
}

TEST_CASE("a profile is as wide as the covariance says, the others being free") {
  const Candidate both{{{"rest_angle", 1}, {"rest_angle", 2}}};
  const Experiment experiment = measured(full_bench(), both, {0.02, -0.01}, 29);
  const Measurements measurements(experiment);
  const Fit fitted = fit_from(Study(experiment), both, {}, {0, 0});
  REQUIRE(fitted.converged);
  for (std::size_t p : {0U, 1U}) {
    const auto j = static_cast<Eigen::Index>(p);
    const double free = 1.96 * std::sqrt(fitted.covariance(j, j)),
                 held = 1.96 / std::sqrt(fitted.information(j, j));
    const Profile bounds = profile(Study(experiment), fitted, p, {}, 1.96 * 1.96);
    // to the curvature of the loss and of the model
    CHECK((bounds.high - bounds.low) / 2 / free == close_to(1).epsilon(0.03));
    CHECK(free > 1.1 * held);
  }
}
