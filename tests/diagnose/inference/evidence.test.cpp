#include "diagnose/inference/evidence.hpp"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

constexpr double pi = std::numbers::pi;

/// A fit as it would be found, with these fitted coordinates and covariance; it leaves nothing.
Fit found(const Measurements& measurements, const Candidate& candidate, const std::vector<double>& parameters,
          const Eigen::MatrixXd& covariance) {
  Fit fit;
  fit.candidate = candidate;
  fit.parameters = parameters;
  fit.at_bound.assign(parameters.size(), false);
  fit.covariance = covariance;
  fit.information = covariance.completeOrthogonalDecomposition().pseudoInverse();
  fit.residual.assign(measurements.size(), 0.0);
  return fit;
}

/// What the parameters alone contribute to the evidence.
double of_parameters(const Experiment& experiment, const Fit& fit) {
  const Measurements measurements(experiment);
  return log_evidence(Study(experiment), fit, {}) - log_likelihood(measurements, fit.residual, {}) -
         log_prior(Study(experiment), fit.candidate);
}

Eigen::MatrixXd variance(double value) {
  return Eigen::MatrixXd::Constant(1, 1, value);
}

}  // namespace

/// How many plain rows the catalogue is worth: what refines another is a tenth as common.
const double plain_rows = [] {
  double sum = 0;
  for (const Effect& row : catalogue()) sum += row.nested.empty() ? 1 : 0.1;
  return sum;
}();

/// Where a row may act on a bench, with every number of elements; where it may not at all, at each joint or
/// at none.
std::vector<EffectAt> places_in(const Study& study, const Effect& row) {
  std::vector<EffectAt> places = possible_effects(study);
  std::erase_if(places, [&](const EffectAt& at) { return at.effect != &row; });
  if (places.empty()) places.emplace_back(row, row.at_joint ? 1 : 0);
  if (!row.orders) return places;
  std::vector<EffectAt> forms;
  for (const EffectAt& at : places)
    for (const Effect* number : row.orders()) forms.emplace_back(*number, at.joint);
  return forms;
}

TEST_CASE(
    "before any reading one cause has 3/4, shared by all effects, refinements less common, and their "
    "places") {
  const Experiment experiment = blank_experiment({3});  // two links
  CHECK(log_prior(Study(experiment), {}) == 0.0);
  CHECK(log_prior(Study(experiment), {{{"gravity"}}}) == close_to(std::log(0.75 / plain_rows)));
  CHECK(log_prior(Study(experiment), {{{"backlash", 2}}}) == close_to(std::log(0.75 / plain_rows / 2)));
  double sum = 0;
  for (const Effect& row : catalogue()) {
    for (const EffectAt& at : places_in(Study(experiment), row))
      sum += std::exp(log_prior(Study(experiment), {{at}}));
  }
  CHECK(sum == close_to(0.75));
}

TEST_CASE("a single joint is not less likely for passive ones beside it, which have no spring") {
  Experiment experiment = blank_experiment({3});
  experiment.joint_stiffness = {2, 0};
  CHECK(log_prior(Study(experiment), {{{"joint_stiffness", 1}}}) == close_to(std::log(0.75 / plain_rows)));
}

TEST_CASE("two causes have 1/5, three 1/20, in any order") {
  const Experiment experiment = blank_experiment({3});
  // of 23^2 ordered pairs an unordered one holds two, of 23^3 triples six; a joint is one of two
  CHECK(log_prior(Study(experiment), {{{"gravity"}, {"force_gain"}}}) ==
        close_to(std::log(0.20 * 2 / (plain_rows * plain_rows))));
  CHECK(log_prior(Study(experiment), {{{"gravity"}, {"backlash", 1}, {"rest_angle", 2}}}) ==
        close_to(std::log(0.05 * 6 / (plain_rows * plain_rows * plain_rows) / 4)));
}

TEST_CASE("beside what machining leaves some cause is as likely as none") {
  const Experiment experiment = blank_experiment({3});
  const Candidate machining{{{"stiffness_spread"}, {"length_spread"}, {"rest_spread"}}};
  const double alone = std::exp(log_prior(Study(experiment), machining));
  CHECK(alone == close_to(0.75 / plain_rows));
  double sum = 0;
  for (const Effect& row : catalogue()) {
    if (machining.has_as_tolerance(EffectAt(row, row.at_joint))) continue;
    for (const EffectAt& at : places_in(Study(experiment), row)) {
      Candidate beside = machining;
      beside.effects.push_back(at);
      sum += std::exp(log_prior(Study(experiment), beside));
    }
  }
  // of the plain rows all but the three
  CHECK(sum == close_to(alone * (plain_rows - 3) / plain_rows));
}

TEST_CASE("the likelihood of one value: normal, and two in a hundred ten times as wide") {
  Experiment experiment = blank_experiment({1});
  experiment.runs[0].readings[0].Fy = std::nan("");
  const Measurements measurements(experiment);
  const auto density = [](double z) {
    return std::log(0.98 * std::exp(-z * z / 2) + 0.002 * std::exp(-z * z / 200));
  };
  for (const double z : {0.0, 1.0, -2.5, 8.0, 30.0})
    CHECK(log_likelihood(measurements, {z}, {}) == close_to(density(z)));
  // 900 sigma away exp() underflows: -z^2 / 200 is left
  CHECK(log_likelihood(measurements, {900.0}, {}) == close_to(std::log(0.002) - 900.0 * 900 / 200));
  NoiseModel wide;
  wide.scale = {1, 1, 2, 2, 1};
  CHECK(log_likelihood(measurements, {3.0}, wide) == close_to(density(1.5)));
}

TEST_CASE(
    "a parameter is charged its prior density times the width that the readings leave, sqrt(2 pi) sigma") {
  const Experiment experiment = blank_experiment({8});
  const Measurements measurements(experiment);
  const double sigma = 1e-4;
  // The prior is constant over so small a sigma to (sigma / scale)^2 = 4e-6.
  constexpr double flat = 4e-6;
  const double left = std::log(std::sqrt(2 * pi) * sigma);
  SUBCASE("of both signs: a Cauchy density of width 0.05") {
    const Candidate gain{{{"force_gain"}}};
    for (const double g : {0.0, 0.05, -0.1}) {
      const double prior = 1 / (pi * 0.05 * (1 + g * g / 0.0025));
      CHECK(of_parameters(experiment, found(measurements, gain, {g}, variance(sigma * sigma))) ==
            close_to(std::log(prior) + left).epsilon(flat));
    }
  }
  SUBCASE("of one sign: twice as high, on one side") {
    const Candidate play{{{"backlash", 1}}};
    const double prior = 2 / (pi * 0.05 * 2);
    CHECK(of_parameters(experiment, found(measurements, play, {0.05}, variance(sigma * sigma))) ==
          close_to(std::log(prior) + left).epsilon(flat));
  }
  SUBCASE("without a natural zero: uniform over its range, beside one of one sign") {
    const Candidate slow{{{"viscoelasticity"}}};
    const auto ranges = Study(experiment).ranges(slow);
    const double uniform = 1 / (ranges[1].high - ranges[1].low);
    const double cauchy = 2 / (pi * 0.2 * 2);
    const Eigen::MatrixXd both = Eigen::Vector2d(sigma * sigma, sigma * sigma).asDiagonal();
    CHECK(of_parameters(experiment, found(measurements, slow, {0.2, ranges[1].low + 0.5}, both)) ==
          close_to(std::log(uniform) + std::log(cauchy) + 2 * left).epsilon(flat));
  }
}

TEST_CASE("of two parameters that the readings tie together the volume left is 2 pi sqrt(det)") {
  const Experiment experiment = blank_experiment({8});
  const Measurements measurements(experiment);
  const Candidate bias{{{"force_bias"}}};
  const double scale = Study(experiment).ranges(bias)[0].scale;
  const double v = 1e-6 * scale * scale;
  Eigen::MatrixXd tied(2, 2);
  tied << v, 0.9 * v, 0.9 * v, v;
  const double prior = 2 * std::log(1 / (pi * scale));
  CHECK(of_parameters(experiment, found(measurements, bias, {0, 0}, tied)) ==
        close_to(prior + std::log(2 * pi * std::sqrt(v * v * (1 - 0.81)))).epsilon(1e-5));
}

TEST_CASE("a parameter at its bound, or one that nothing shows, is not charged") {
  const Experiment experiment = blank_experiment({8});
  const Measurements measurements(experiment);
  Fit fit = found(measurements, {{{"force_gain"}}}, {3.0}, variance(0));
  CHECK(of_parameters(experiment, fit) == doctest::Approx(0));
  fit.at_bound[0] = true;
  fit.information = variance(1e4);
  CHECK(of_parameters(experiment, fit) == doctest::Approx(0));
}
