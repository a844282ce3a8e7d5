#include "diagnose/discrepancy/kernel.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "diagnose/priors.hpp"
#include "tests/close_to.hpp"
#include "tests/diagnose/bench.hpp"

using namespace plumbline;
using namespace plumbline::diagnose;
using namespace plumbline::diagnose::test;

namespace {

const std::vector<double> lengths{0.2, 0.5, 1.5};

/// Covariance of the discrepancy of a block, by length.
std::vector<MatrixXd> covariances(const Experiment& experiment, std::size_t block = 0) {
  const Measurements measurements(experiment);
  const DiscrepancyBasis basis =
      discrepancy_basis(CommandStates(experiment), measurements, measurements.blocks()[block], lengths);
  std::vector<MatrixXd> all;
  for (const MatrixXd& inner : basis.covariance) all.emplace_back(basis.phi * inner * basis.phi.transpose());
  return all;
}

/// A press there and back from rest.
Experiment one_press() {
  Experiment experiment = three_links();
  experiment.noise[Channel::Name::q] = 0;
  press(experiment, {0.3, -0.5, 0.4}, {-0.06, 0}, 20, true);
  for (Run& run : experiment.runs)
    for (Reading& reading : run.readings) reading.value.resize(column_q);
  return experiment;
}

/// What is left out of the trace is spread over the values.
constexpr double of_cutting = 0.02;

}  // namespace

TEST_CASE("commands are counted from rest over the farthest, with their direction and the way so far") {
  const Experiment experiment = one_press();
  const CommandStates states(experiment);
  REQUIRE(states.of.size() == 1);
  const std::vector<CommandState>& run = states.of[0];
  CHECK(run.front().command[0].norm() < 1e-12);
  CHECK(run[20].command[0].norm() == close_to(1));
  CHECK(run[5].command[0].norm() == close_to(0.25));
  CHECK(run[20].direction[0] == 1);
  CHECK(run[21].direction[0] == -1);
  CHECK(run[10].progress == close_to(0.25));
  CHECK(run.back().progress == close_to(1));
  CHECK(states.knows_rest[0]);
}

TEST_CASE("a discrepancy is a covariance that is small at rest and smoother the longer it is") {
  const std::vector<MatrixXd> all = covariances(one_press());
  double last = -1;
  for (const MatrixXd& one : all) {
    CHECK(one.rows() == 41);
    CHECK((one - one.transpose()).cwiseAbs().maxCoeff() < 1e-9);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(one);
    CHECK(eigen.eigenvalues().minCoeff() > -1e-9);
    CHECK(std::abs(one(0, 0) - priors::rest_share) < of_cutting);
    const double neighbours = one(12, 16) / std::sqrt(one(12, 12) * one(16, 16));
    CHECK(neighbours > last);
    last = neighbours;
  }
}

TEST_CASE("the same command on the way there and back shares less than neighbours on one way") {
  for (const MatrixXd& one : covariances(one_press())) {
    const auto correlation = [&](Eigen::Index i, Eigen::Index j) {
      return one(i, j) / std::sqrt(one(i, i) * one(j, j));
    };
    CHECK(correlation(15, 16) > correlation(15, 25));  // reading 25 comes by where 15 was
  }
}

TEST_CASE("a discrepancy does not depend on units, on the order of the runs, or on the channel") {
  Experiment experiment = one_press();
  press(experiment, {0.2, -0.5, 0.4}, {-0.03, 0.02}, 15, false);
  for (Reading& reading : experiment.runs[1].readings) reading.value.resize(column_q);
  const std::vector<MatrixXd> all = covariances(experiment), other = covariances(experiment, 1);
  Experiment larger = experiment;
  for (double& length : larger.link_length) length *= 1000;
  for (Run& run : larger.runs)
    for (Reading& reading : run.readings) reading[column_x] *= 1000, reading[column_y] *= 1000;
  const std::vector<MatrixXd> in_millimetres = covariances(larger);
  Experiment turned = experiment;
  std::swap(turned.runs[0], turned.runs[1]);
  const std::vector<MatrixXd> swapped = covariances(turned);
  for (std::size_t l = 0; l < lengths.size(); ++l) {
    CHECK((all[l] - other[l]).cwiseAbs().maxCoeff() < 1e-9);
    CHECK((all[l] - in_millimetres[l]).cwiseAbs().maxCoeff() < 1e-6);
    // other pivots may be taken among equals: up to what is left out
    CHECK((all[l].topLeftCorner(41, 41) - swapped[l].bottomRightCorner(41, 41)).cwiseAbs().maxCoeff() <
          of_cutting);
    CHECK((all[l].topRightCorner(41, 16) - swapped[l].bottomLeftCorner(41, 16)).cwiseAbs().maxCoeff() <
          of_cutting);
  }
}

TEST_CASE("runs of unlike rest shapes share little, and runs of another control nothing") {
  const auto shared = [](const std::vector<double>& rest) {
    Experiment experiment = one_press();
    press(experiment, rest, {-0.06, 0}, 20, true);
    for (Run& run : experiment.runs)
      for (Reading& reading : run.readings) reading.value.resize(column_q);
    const MatrixXd one = covariances(experiment)[1];
    return one(15, 41 + 15) / one(15, 15);
  };
  const double same = shared({0.3, -0.5, 0.4}), near = shared({0.4, -0.6, 0.5}),
               far = shared({-0.4, 0.3, 0.5});
  CHECK(same > near);
  CHECK(near > far);
  CHECK(far > 0);
  const CommandStates states(full_bench());
  CHECK(states.alike(0, 2) == 0);
  CHECK(states.alike(0, 0) == 1);
}
