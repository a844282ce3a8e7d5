#include "diagnose/design/separation.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Three readings of a force along x.
Study three_values() {
  Experiment experiment = three_links();
  experiment.noise[Channel::Name::q] = 0;
  press(experiment, {0.3, -0.5, 0.4}, {-0.02, 0}, 2, false);
  for (Reading& reading : experiment.runs[0].readings)
    reading[column_Fy] = nan_value(), reading.value.resize(column_q);
  return Study(experiment);
}

/// A hypothesis that leaves these residuals, with none of its parameters at a bound.
Hypothesis leaving(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual) {
  Hypothesis hypothesis;
  hypothesis.jacobian = jacobian;
  hypothesis.residual = residual;
  hypothesis.at_bound.assign(static_cast<std::size_t>(jacobian.cols()), false);
  return hypothesis;
}

}  // namespace

TEST_CASE("what one hypothesis predicts beyond another is its residual less") {
  const Study study = three_values();
  REQUIRE(study.measurements().size() == 3);
  NoiseEstimate noise = declared_noise(study);
  const Eigen::MatrixXd slope{{1.0, 0.0}, {0.0, 2.0}, {1.0, 1.0}};
  const Hypothesis truth = leaving(slope, Eigen::Vector3d(0.5, -1, 2));
  Hypothesis imitator = leaving(slope, Eigen::Vector3d(1, 1, 1));
  const auto rows = [&] { return linearised_alternative(study.measurements(), noise, truth, imitator); };
  CHECK(rows().difference == Eigen::Vector3d(0.5, 2, -1));
  CHECK(rows().slope == slope);
  // Normal equations of two columns: sums (2, 1; 1, 5), (-0.5, 3); the step is (-5.5, 6.5) / 9.
  const double left = 0.25 + 4 + 1 - (-0.5 * -5.5 + 3 * 6.5) / 9;
  CHECK(separation(rows()) == close_to(left));
  imitator.at_bound = {false, true};
  CHECK(rows().slope.col(0) == slope.col(0));
  CHECK(rows().slope.col(1).norm() == 0);
  CHECK(separation(rows()) == close_to(5.25 - 0.25 / 2));
  imitator.at_bound = {true, false};
  CHECK(separation(rows()) == close_to(5.25 - 9.0 / 5));
  imitator.at_bound = {true, true};
  CHECK(separation(rows()) == close_to(5.25));
  // In twice the noise squares are a quarter; an outlier tells nothing.
  noise.channels.front().scale = 2;
  CHECK(separation(rows()) == close_to(5.25 / 4));
  noise.shape.outlier[1] = true;
  CHECK(separation(rows()) == close_to(1.25 / 4));
}

TEST_CASE("a separation does not depend on the units of parameters, on rows that matter, or on their order") {
  Eigen::MatrixXd slope{{1.0, 2.0}, {0.0, 1.0}, {3.0, -1.0}, {1.0, 1.0}, {2.0, 0.5}};
  const Eigen::VectorXd difference{{1.0, -2.0, 0.5, 3.0, 1.0}};
  const double whole = separation({difference, slope});
  CHECK(whole > 1);
  Eigen::MatrixXd other = slope;
  other.col(0) *= 1e-9;
  other.col(1) *= 1e6;
  CHECK(separation({difference, other}) == close_to(whole).epsilon(1e-9));
  const LinearisedAlternative fewer = reduced({difference, slope});
  CHECK(fewer.slope.rows() == 3);
  CHECK(fewer.slope.cols() == 2);
  CHECK(separation(fewer) == close_to(whole).epsilon(1e-9));
  const LinearisedAlternative both =
      stacked({difference.head(2), slope.topRows(2)}, {difference.tail(3), slope.bottomRows(3)});
  CHECK(both.difference == difference);
  CHECK(both.slope == slope);
  CHECK(separation({difference, Eigen::MatrixXd(5, 0)}) == close_to(1 + 4 + 0.25 + 9 + 1));
  CHECK(separation({difference, Eigen::MatrixXd::Zero(5, 1)}) == close_to(15.25));
}
