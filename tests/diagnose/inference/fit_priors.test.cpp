#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "diagnose/inference/fit.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

Study pressed_twice(const Candidate& truth, const std::vector<double>& values, int outlier = 0) {
  Experiment bench = three_links();
  press(bench, {0.3, -0.5, 0.4}, {-0.05, 0}, 10, true);
  press(bench, {-0.4, 0.3, 0.5}, {-0.04, 0.03}, 10, false);
  return Study(measured(bench, truth, values, 7, outlier));
}

/// What the loss of a fit is, from what it leaves and the priors of its tolerances.
double loss_of(const Study& study, const Fit& fitted, const FitSettings& settings) {
  double sum = 0;
  for (const double z : fitted.whitened) sum += huber(z, settings.outlier_bound);
  const std::vector<ParameterRange> ranges = study.ranges(fitted.candidate);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].tolerance > 0) sum += std::pow(fitted.parameters[p] / ranges[p].tolerance, 2);
  return sum;
}

/// Half the slope of that loss by each parameter.
Eigen::VectorXd slope_of(const Study& study, const Fit& fitted, double bound) {
  const std::vector<ParameterRange> ranges = study.ranges(fitted.candidate);
  Eigen::VectorXd slope = Eigen::VectorXd::Zero(fitted.jacobian.cols());
  for (Eigen::Index i = 0; i < fitted.jacobian.rows(); ++i)
    slope += std::clamp(fitted.whitened[static_cast<std::size_t>(i)], -bound, bound) *
             fitted.jacobian.row(i).transpose();
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].tolerance > 0)
      slope(static_cast<Eigen::Index>(p)) += fitted.parameters[p] * std::pow(ranges[p].tolerance, -2);
  return slope;
}

/// A fit ends where another iteration gains less than 1e-5 of its cost: a Newton step of the root of that,
/// in units of standard deviations.
void check_minimum(const Study& study, const Fit& fitted, const FitSettings& settings) {
  REQUIRE(fitted.converged);
  CHECK(fitted.cost == close_to(loss_of(study, fitted, settings)).epsilon(1e-9));
  const Eigen::VectorXd step = fitted.covariance * slope_of(study, fitted, settings.outlier_bound);
  const double ends = std::sqrt(1e-5 * fitted.cost);
  for (Eigen::Index p = 0; p < step.size(); ++p)
    CHECK(std::abs(step(p)) <= ends * std::sqrt(fitted.covariance(p, p)));
}

}  // namespace

TEST_CASE("a fit ends where its loss, outliers and priors counted, is flat") {
  const Candidate free{{{"force_gain"}, {"rest_angle", 2}}}, held{{{"force_gain"}, {"stiffness_spread"}}};
  for (const int outlier : {0, 9}) {
    const Study study = pressed_twice(free, {0.05, 0.02}, outlier);
    for (const Candidate& candidate : {free, held}) {
      CAPTURE(candidate.label());
      check_minimum(study, fit(study, candidate, {}), {});
      FitSettings settings;
      settings.outlier_bound = 2;
      settings.noise.correlation.fill(0.3);
      check_minimum(study, fit(study, candidate, settings), settings);
    }
  }
}

TEST_CASE("the covariance of what tolerances hold is the inverse of what is told and of their priors") {
  const Candidate held{{{"force_gain"}, {"stiffness_spread"}}};
  const Study study = pressed_twice(held, {0.05, 0.1, -0.05, 0.08});
  const Fit fitted = fit(study, held, {});
  REQUIRE(std::none_of(fitted.at_bound.begin(), fitted.at_bound.end(), [](bool one) { return one; }));
  Eigen::MatrixXd precision = fitted.information;
  const std::vector<ParameterRange> ranges = study.ranges(held);
  for (std::size_t p = 0; p < ranges.size(); ++p)
    if (ranges[p].tolerance > 0)
      precision(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(p)) +=
          std::pow(ranges[p].tolerance, -2);
  const Eigen::MatrixXd product = precision * fitted.covariance;
  for (Eigen::Index i = 0; i < product.rows(); ++i)
    for (Eigen::Index j = 0; j < product.cols(); ++j)
      CHECK(std::abs(product(i, j) - (i == j ? 1 : 0)) < 1e-6);
}

TEST_CASE("of several starts the one is taken that leaves least, and none that the rig cannot follow") {
  const Study study = pressed_twice({{{"joint_stiffness", 2}}}, {0.1});
  const Candidate one{{{"joint_stiffness", 2}}};
  const Fit from_near = fit(study, one, {}, {{{0.1}, {5}}, 1}),
            from_far = fit(study, one, {}, {{{5}, {0.1}}, 1});
  CHECK(from_near.parameters == from_far.parameters);
  CHECK(from_near.parameters == fit_from(study, one, {}, {0.1}).parameters);
  const Fit nominal = fit_from(study, {}, {}, {});
  CHECK(nominal.parameters.empty());
  CHECK(nominal.converged);
  CHECK(nominal.cost == close_to(loss_of(study, nominal, {})).epsilon(1e-9));
  CHECK(nominal.cost > from_near.cost);
}

TEST_CASE("a profile rises by what it is asked to, with the others where they leave least") {
  const Candidate both{{{"rest_angle", 1}, {"force_gain"}}};
  const Study study = pressed_twice(both, {0.02, 0.05});
  const Fit fitted = fit(study, both, {});
  for (const double rise : {1.0, 3.84, 25.0}) {
    const Profile bounds = profile(study, fitted, 0, {}, rise);
    for (const double value : {bounds.low, bounds.high}) {
      // the loss at the bound, the gain fitted by itself: a minimum over one parameter of three looks
      const auto cost_at = [&](double gain) {
        Fit there = fitted;
        there.parameters = {value, gain};
        there.whitened =
            whiten(study.measurements(), study.residual(predict(study, both, there.parameters)), {});
        return loss_of(study, there, {});
      };
      const double step = std::sqrt(fitted.covariance(1, 1)), at = fitted.parameters[1];
      const double shift = (value - fitted.parameters[0]) * fitted.covariance(0, 1) / fitted.covariance(0, 0);
      const double a = cost_at(at + shift - step), b = cost_at(at + shift), c = cost_at(at + shift + step);
      const double least = b - (c - a) * (c - a) / (8 * (a + c - 2 * b));
      // found to a hundredth of the rise, or of the first step
      CHECK((least - fitted.cost) / rise == close_to(1).epsilon(0.035));
    }
  }
}

TEST_CASE("a bound of a profile that the physical range cuts off is its end") {
  const Candidate rubbing{{{"guide_friction"}}};
  const Study study = pressed_twice(rubbing, {0.004});
  const Fit fitted = fit(study, rubbing, {});
  REQUIRE_FALSE(fitted.at_bound[0]);
  const double sigma = std::sqrt(fitted.covariance(0, 0)), value = fitted.parameters[0];
  // Nothing of it is so many standard deviations away: a rise of the square of fewer stays inside. Bounds are
  // found to a hundredth of the rise, a half of that of its root; readings that come to count as outliers add
  // to it.
  const double away = value / sigma;
  const Profile inside = profile(study, fitted, 0, {}, std::pow(0.5 * away, 2)),
                cut = profile(study, fitted, 0, {}, std::pow(2 * away, 2));
  CHECK(inside.low == close_to(value / 2).epsilon(0.03));
  CHECK(inside.high == close_to(value * 1.5).epsilon(0.03));
  CHECK(cut.low == 0);
  CHECK(cut.high == close_to(3 * value).epsilon(0.03));
}
