#include "diagnose/motion/hypothesis.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "tests/diagnose/motion/logs.hpp"

namespace plumbline::motion {
namespace {

/// A row alone, fitted to a log of the stated drive under such a weight.
Hypothesis fitted_alone(const char* id, double gravity) {
  Bench bench;
  bench.nominal = planted_drive(Term::command_delay, 0);
  bench.sigma = 5e-4;
  MotionLog log = test_log(bench.nominal, 8, 0);
  log.gravity = gravity;
  log.position = angles_of(bench.nominal, log, {0, 0, log.time.size()}, 0.0, 0.0);
  bench.logs.push_back(log);
  const Study study(bench);
  const auto row =
      std::find_if(study.rows().begin(), study.rows().end(), [&](const Row& one) { return one.id == id; });
  REQUIRE(row != study.rows().end());
  Quantities units{};
  units.fill(bench.sigma);
  std::vector<double> guess;
  for (const Parameter& one : row->parameters) guess.push_back(one.guess);
  return fitted(study, Likelihood(units, 0.1), {{&*row}}, {guess, study.rough_begins()});
}

}  // namespace

TEST_CASE("the zero of the encoder shows beside a weight, and without one it cannot") {
  CHECK(fitted_alone("encoder_zero", 0.59).shows);
  CHECK(!fitted_alone("encoder_zero", 0).shows);
}

TEST_CASE("the error of the step is no discrepancy: with it declared a coarse motion is as modelled") {
  // The unit is a hundred times the noise, and so is what the step leaves: noise alone is impossible.
  SegmentMeans left{0,
                    std::vector<std::size_t>(20, 0),
                    Eigen::VectorXd::LinSpaced(20, 0, 1),
                    Eigen::VectorXd::Constant(20, 0.01),
                    {},
                    Eigen::MatrixXd::Zero(20, 2),
                    Eigen::VectorXd::Constant(20, 1e-8),
                    Begin::Zero()};
  const Quantities unit{0.01, 1, 1, 1};
  const Look exact = Likelihood(unit, 0.1).look({left}),
             declared = Likelihood(unit, 0.1, {unit}).look({left});
  CHECK(exact.best.amplitude > 0);
  CHECK(declared.best.amplitude == 0);
}

}  // namespace plumbline::motion
