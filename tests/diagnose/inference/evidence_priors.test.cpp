#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/evidence.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/simulated_noise.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;

namespace {

/// A fit at these values of which the readings tell so much; it leaves nothing.
Fit told_of(const Study& study, const Candidate& candidate, const std::vector<double>& values,
            const Eigen::MatrixXd& information) {
  Fit fit;
  fit.candidate = candidate;
  fit.parameters = values;
  fit.at_bound.assign(values.size(), false);
  fit.information = information;
  fit.residual.assign(study.measurements().size(), 0.0);
  return fit;
}

/// What the parameters alone contribute to the evidence.
double parameters_worth(const Study& study, const Fit& fit) {
  return log_evidence(study, fit, {}) - log_likelihood(study.measurements(), fit.residual, {}) -
         log_prior(study, fit.candidate);
}

Study two_blank_links() {
  return Study(blank_experiment({8}));
}

/// The catalogue counted as evidence counts it: what refines another row is a tenth as common.
double catalogue_worth(const Study& study) {
  double sum = 0;
  for (const Effect* row : study.effects()) sum += row->nested.empty() ? 1 : beliefs::refinement;
  return sum;
}

double prior_density(double value, double deviation) {
  return std::exp(-value * value / (2 * deviation * deviation)) /
         (deviation * std::sqrt(2 * std::numbers::pi));
}

}  // namespace

TEST_CASE("what a tolerance holds has a normal prior, twice as high where one side alone can be") {
  const Study study = two_blank_links();
  // A width of the posterior so far below the tolerance that its prior is flat there: 1e-8 in squares.
  constexpr double share = 1e-4;
  for (const char* id : {"stiffness_spread", "play"}) {
    CAPTURE(id);
    const Candidate spread{{EffectAt(id)}};
    const double tolerance = study.ranges(spread)[0].tolerance;
    REQUIRE(tolerance > 0);
    const double sides = study.ranges(spread)[0].low < 0 ? 1 : 2, sigma = share * tolerance;
    CHECK(sides == (std::string(id) == "play" ? 2 : 1));
    const Eigen::MatrixXd information = std::pow(sigma, -2) * Eigen::Matrix2d::Identity();
    const double one = 0.7 * tolerance, other = 2 * tolerance;
    const double expected = sides * prior_density(one, tolerance) * sides * prior_density(other, tolerance) *
                            std::pow(std::sqrt(2 * std::numbers::pi) * sigma, 2);
    CHECK(parameters_worth(study, told_of(study, spread, {one, other}, information)) ==
          close_to(std::log(expected)).epsilon(1e-8));
    CHECK(tolerance_charge(study, told_of(study, spread, {one, other}, information)) == close_to(0.49 + 4));
  }
  CHECK(tolerance_charge(study, told_of(study, {{{"force_gain"}}}, {0.1}, Eigen::MatrixXd::Ones(1, 1))) == 0);
  const Candidate beside{{{"force_gain"}, {"rest_spread"}}};
  const double tolerance = study.ranges(beside)[1].tolerance;
  CHECK(tolerance_charge(study, told_of(study, beside, {5, tolerance, 3 * tolerance},
                                        Eigen::Matrix3d::Identity())) == close_to(10));
}

TEST_CASE("a rigidity has its zero at nothing of it, and the Cauchy density of a scale") {
  const Study study = two_blank_links();
  const Candidate bending{{{"link_bending"}}};
  const ParameterRange range = study.ranges(bending)[0];
  REQUIRE(range.coordinate == Coordinate::reciprocal);
  REQUIRE(range.low > 0);
  const double sigma = 1e-4 * range.scale;
  const double density = 2 / (std::numbers::pi * range.scale * (1 + 4));
  CHECK(parameters_worth(study, told_of(study, bending, {2 * range.scale},
                                        Eigen::MatrixXd::Constant(1, 1, std::pow(sigma, -2)))) ==
        close_to(std::log(density * std::sqrt(2 * std::numbers::pi) * sigma)).epsilon(1e-7));
}

TEST_CASE("readings that tell little leave the width of the prior") {
  const Study study = two_blank_links();
  const Candidate gain{{{"force_gain"}}};
  const double scale = study.ranges(gain)[0].scale;
  // The Gaussian as high as a Cauchy density is sqrt(pi / 2) of its scale wide.
  const double believed = std::sqrt(std::numbers::pi / 2) * scale;
  for (const double told : {1e-6, 1.0, 8.0}) {
    const Eigen::MatrixXd information = Eigen::MatrixXd::Constant(1, 1, told / (believed * believed));
    const double width = believed / std::sqrt(1 + told);
    CHECK(parameters_worth(study, told_of(study, gain, {scale}, information)) ==
          close_to(std::log(std::sqrt(2 * std::numbers::pi) * width / (2 * std::numbers::pi * scale))));
    CHECK(posterior_covariance(study, told_of(study, gain, {scale}, information))(0, 0) ==
          close_to(width * width));
  }
  const Fit untold = told_of(study, gain, {scale}, Eigen::MatrixXd::Zero(1, 1));
  CHECK(parameters_worth(study, untold) == doctest::Approx(0));
  CHECK(posterior_covariance(study, untold)(0, 0) == close_to(believed * believed));
}

TEST_CASE("what readings do not tell is worth nothing, whatever the shape of the prior") {
  // The mean of a likelihood over a prior is never more than the likelihood at its best.
  const Study study = two_blank_links();
  for (const EffectAt& at : possible_effects(study)) {
    const std::vector<ParameterRange> ranges = study.ranges(at);
    std::vector<double> values;
    for (const ParameterRange& range : ranges) values.push_back(std::clamp(0.0, range.low, range.high));
    const auto count = static_cast<Eigen::Index>(ranges.size());
    Eigen::MatrixXd hardly = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index p = 0; p < count; ++p)
      hardly(p, p) = 1e-9 / std::pow(ranges[static_cast<std::size_t>(p)].scale, 2);
    CAPTURE(at.label());
    CHECK(parameters_worth(study, told_of(study, {{at}}, values, hardly)) < 1e-9);
  }
}

TEST_CASE(
    "the posterior covariance is the inverse of what is told and what was believed; nothing at a bound") {
  const Study study = two_blank_links();
  const Candidate three{{{"force_bias"}, {"force_gain"}}};
  const std::vector<ParameterRange> ranges = study.ranges(three);
  Eigen::Vector3d width;
  for (Eigen::Index p = 0; p < 3; ++p)  // of Cauchy densities
    width(p) = std::sqrt(std::numbers::pi / 2) * ranges[static_cast<std::size_t>(p)].scale;
  const Eigen::Matrix3d in_widths{{4, 1, -2}, {1, 3, 0.5}, {-2, 0.5, 5}};
  const Eigen::MatrixXd information =
      width.cwiseInverse().asDiagonal() * in_widths * width.cwiseInverse().asDiagonal();
  Fit fit = told_of(study, three, {0, 0, 0}, information);
  const Eigen::Matrix3d inverse = (in_widths + Eigen::Matrix3d::Identity()).inverse();
  const Eigen::MatrixXd found = posterior_covariance(study, fit);
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) CHECK(found(i, j) == close_to(width(i) * inverse(i, j) * width(j)));
  fit.at_bound[1] = true;
  const Eigen::MatrixXd bound = posterior_covariance(study, fit);
  CHECK(bound.row(1).norm() == 0);
  CHECK(bound.col(1).norm() == 0);
  const double det = 5 * 6 - 4;  // of the other two: (5, -2; -2, 6)
  CHECK(bound(0, 0) == close_to(width(0) * width(0) * 6 / det));
  CHECK(bound(0, 2) == close_to(width(0) * width(2) * 2 / det));
}

TEST_CASE("what machining leaves is one cause among the others, and beside others it is none") {
  const Study study = two_blank_links();
  const double all = catalogue_worth(study);
  Candidate machining{{{"stiffness_spread"}, {"length_spread"}, {"rest_spread"}}};
  REQUIRE(machining.has_all_tolerances());
  CHECK(log_prior(study, machining) == close_to(std::log(beliefs::one_cause / all)));
  const double beside = beliefs::cause_beside_machining / all;
  machining.effects.emplace_back("gravity");
  CHECK(log_prior(study, machining) == close_to(std::log(beside * beliefs::one_cause / all)));
  machining.effects.emplace_back("force_gain");
  CHECK(log_prior(study, machining) == close_to(std::log(beside * beliefs::two_causes * 2 / (all * all))));
  // two of its three kinds are two causes
  CHECK(log_prior(study, {{{"stiffness_spread"}, {"length_spread"}}}) ==
        close_to(std::log(beliefs::two_causes * 2 / (all * all))));
  const Candidate four{{{"gravity"}, {"force_gain"}, {"force_bias"}, {"eccentric_load"}}};
  CHECK(log_prior(study, four) == close_to(std::log(beliefs::three_causes * 24 / std::pow(all, 4))));
  const Candidate refined{{EffectAt("direction_friction")}};
  REQUIRE_FALSE(refined.effects[0].effect->nested.empty());
  CHECK(log_prior(study, refined) == close_to(std::log(beliefs::one_cause * beliefs::refinement / all)));
}
