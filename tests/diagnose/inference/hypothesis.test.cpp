#include "diagnose/inference/hypothesis.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "diagnose/inference/size_prior.hpp"
#include "diagnose/inference/white_noise_fit.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

// Under weights a joint turns in proportion to 1 / (1 + a): a step of Gauss and Newton's from the nominal
// model overshoots a joint that is three times softer by far, to where it is twenty times softer.
TEST_CASE("a fit finds a stiffness wherever in its range it is") {
  Experiment bench = three_links();
  load(bench, {0.2, 0.3, -0.3}, {0, 0}, {-0.3, 0.2}, 15);
  for (const double a : {-0.9, -0.7, -0.5, -0.2, 0.5, 2.0, 8.0}) {
    CAPTURE(a);
    const Study study(measured(bench, only("joint_stiffness", 2), {a}, 17));
    const Hypothesis found = fit_in_white_noise(study, only("joint_stiffness", 2));
    REQUIRE(found.converged);
    // Three standard deviations of the sum of so many squares about their number.
    const auto values = static_cast<double>(study.measurements().size());
    CHECK(found.residual.squaredNorm() < values + 3 * std::sqrt(2 * values));
  }
}

// A sensor's zero moves the readings in proportion: the likelihood is Gaussian in it, so that what Laplace's
// method gives is the integral itself.
TEST_CASE("the volume of an effect is the integral of its prior over the sizes, times the likelihood") {
  Experiment bench = three_links();
  load(bench, {0.2, 0.3, -0.3}, {0, 0}, {-0.3, 0.2}, 15);
  for (const double zero : {0.0, 0.3, 3.0}) {
    CAPTURE(zero);
    const Candidate cause = only("position_offset");
    const Study nominal(bench);
    const std::vector<ParameterRange> ranges = nominal.ranges(cause);
    REQUIRE(ranges.size() == 2);
    const Study study(measured(bench, cause, {zero * ranges[0].scale, -zero * ranges[1].scale}, 19));
    const Hypothesis found = fit_in_white_noise(study, cause);
    REQUIRE(found.converged);
    const MatrixXd& information = found.look.information;
    // By a fine grid in both offsets over all that the likelihood or the narrowest prior knows.
    double integral = 0;
    for (const GridSize& size : size_grid()) {
      const auto over = [&](Eigen::Index p) {
        const auto k = static_cast<std::size_t>(p);
        const double width = size.size * ranges[k].scale, precision = information(p, p);
        const double at = found.parameters[k];
        double sum = 0, step = 0.01 / std::sqrt(precision + 1 / (width * width));
        const double mean = at * precision / (precision + 1 / (width * width));
        for (int i = -800; i <= 800; ++i) {
          const double x = mean + i * step;
          sum += step * std::exp(-precision * (x - at) * (x - at) / 2 - x * x / (2 * width * width)) /
                 (width * std::sqrt(2 * std::numbers::pi));
        }
        return sum;
      };
      integral += std::exp(size.log_prior) * over(0) * over(1);
    }
    // The two offsets are read by two channels: nothing is off the diagonal. Eight standard deviations of
    // the trapezoidal rule leave 1e-12; the rest is what the fit's own prior moves the maximum by.
    CHECK(std::abs(information(0, 1)) < 1e-9 * information(0, 0));
    CHECK(found.log_volume == close_to(std::log(integral)).epsilon(1e-6));
  }
}
