#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>

#include "diagnose/discrepancy/implied_shares.hpp"
#include "diagnose/noise/outliers.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

/// Two runs one way, of which the forces alone are read: no deflection comes twice, but for rounding.
Experiment two_ways() {
  Experiment experiment = three_links();
  experiment.noise.q = 0;
  press(experiment, {0.3, -0.5, 0.4}, {-0.05, 0}, 40, false);
  press(experiment, {-0.4, 0.3, 0.5}, {-0.04, 0.03}, 36, false);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.q.clear();
  return measured(experiment, {}, {}, 5);
}

/// The terms of a law at a reading: hats over evenly laid knots, of either direction of motion.
Eigen::RowVectorXd hats(double deflection, double low, double high, Eigen::Index knots, bool coming_back) {
  Eigen::RowVectorXd terms = Eigen::RowVectorXd::Zero(2 * knots);
  const double apart = (high - low) / static_cast<double>(knots - 1);
  for (Eigen::Index k = 0; k < knots; ++k)
    terms((coming_back ? knots : 0) + k) =
        std::max(0.0, 1 - std::abs(deflection - low - apart * static_cast<double>(k)) / apart);
  // What rounding leaves of a hat beyond its neighbours would be a column of its own.
  return (terms.array() < 1e-9).select(0, terms);
}

/// Schwarz's criterion of a law at one joint, as the header tells it, by its own sums.
double least_criterion(const Study& study, const std::vector<double>& residual, const NoiseModel& noise,
                       std::size_t joint) {
  const Experiment& experiment = study.experiment();
  const Prediction answer = predict(study, {{{"rest_angle", joint + 1}}}, {0.0}, true);
  const std::vector<double> per_torque = study.measurements().in_sigmas(answer.sensitivity[0]);
  const auto column = column_q + static_cast<Eigen::Index>(joint);
  double low = 0, high = 0, least = 1e300;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    low = std::min(low, answer.runs[r].col(column).minCoeff() - experiment.runs[r].rest[joint]);
    high = std::max(high, answer.runs[r].col(column).maxCoeff() - experiment.runs[r].rest[joint]);
  }
  const auto rows = static_cast<Eigen::Index>(residual.size());
  for (const Eigen::Index knots : {4, 8, 16})
    for (const bool constants : {false, true}) {
      Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(rows, 2 * knots + (constants ? 2 : 0));
      Eigen::VectorXd values(rows);
      for (const Series& series : study.measurements().series()) {
        const double scale = noise.of(series.channel);
        for (std::size_t i = 0; i < series.readings.size(); ++i) {
          const auto row = static_cast<Eigen::Index>(series.first + i),
                     at = static_cast<Eigen::Index>(series.readings[i]);
          const bool bends_back =
              at > 0 && answer.runs[series.run](at, column) < answer.runs[series.run](at - 1, column);
          const double share = per_torque[series.first + i] / scale;
          slope.row(row).head(2 * knots) =
              share * hats(answer.runs[series.run](at, column) - experiment.runs[series.run].rest[joint], low,
                           high, knots, bends_back);
          if (constants) slope(row, 2 * knots + static_cast<Eigen::Index>(series.run)) = share;
          values(row) = residual[series.first + i] / scale;
        }
      }
      const auto factors = slope.colPivHouseholderQr();
      const double left = (values - slope * factors.solve(values)).squaredNorm(),
                   independent = static_cast<double>(rows) / 4;
      least = std::min(least, independent * std::log(std::max(1.0, left)) +
                                  static_cast<double>(factors.rank()) * std::log(independent));
    }
  return least;
}

}  // namespace

TEST_CASE(
    "a joint's chance to be the place of a torque law is that of its best law, by Schwarz's criterion") {
  const Study study(two_ways());
  NoiseModel noise;
  noise.scale.fill(1.5);
  noise.scale[3] = 2;
  // Torque that is missing at two joints, and waves that no law explains; so little that chances are open.
  const std::vector<double> first =
      study.measurements().in_sigmas(predict(study, {{{"rest_angle", 1}}}, {0.0}, true).sensitivity[0]);
  const std::vector<double> third =
      study.measurements().in_sigmas(predict(study, {{{"rest_angle", 3}}}, {0.0}, true).sensitivity[0]);
  const auto largest = [](const std::vector<double>& values) {
    double size = 0;
    for (const double one : values) size = std::max(size, std::abs(one));
    return size;
  };
  std::vector<double> residual(first.size());
  for (std::size_t i = 0; i < residual.size(); ++i)
    residual[i] = 2.5 * first[i] / largest(first) + 1.5 * third[i] / largest(third) +
                  2 * std::sin(2.4 * static_cast<double>(i));
  REQUIRE(std::none_of(residual.begin(), residual.end(), [](double one) { return std::abs(one) > 6; }));
  const std::vector<double> clean = without_outliers(study.measurements(), residual);
  std::vector<double> weight;
  for (std::size_t joint = 0; joint < 3; ++joint)
    weight.push_back(least_criterion(study, clean, noise, joint));
  const double best = *std::min_element(weight.begin(), weight.end());
  double sum = 0;
  for (double& one : weight) sum += one = std::exp((best - one) / 2);
  const std::vector<JointShare> shares = shares_by_torque_law(study, residual, noise);
  REQUIRE(shares.size() == 3);
  int open = 0;
  for (const JointShare& one : shares) {
    CHECK(one.share == close_to(weight[one.joint - 1] / sum).epsilon(1e-6));
    open += one.share > 1e-3 ? 1 : 0;
  }
  CHECK(open >= 2);
}

TEST_CASE("a passive joint has no chance") {
  Experiment experiment = two_ways();
  experiment.joint_stiffness[1] = 0;
  const Study study(measured(experiment, {}, {}, 5));
  const std::vector<double> residual(study.measurements().size(), 1.0);
  for (const JointShare& one : shares_by_torque_law(study, residual, {}))
    if (one.joint == 2) CHECK(one.share == 0);
}
