#include "diagnose/inference/hypothesis.hpp"

#include <doctest/doctest.h>

#include "diagnose/inference/white_noise_fit.hpp"
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
