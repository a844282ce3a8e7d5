#pragma once

#include <random>

#include "diagnose/inference/study.hpp"
#include "tests/diagnose/bench.hpp"

namespace plumbline::diagnose::test {

/// White noise on a bench of four runs.
struct DrawnBench {
  Study study{four_presses()};
  VectorXd residual = VectorXd::Zero(static_cast<Eigen::Index>(study.measurements().size()));

  static Experiment four_presses() {
    Experiment experiment = three_links();
    for (int run = 0; run < 4; ++run) press(experiment, {0.3, -0.5, 0.4}, {-0.01 * (run + 3), 0}, 20, false);
    return experiment;
  }
  explicit DrawnBench(unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal;
    for (double& one : residual) one = normal(engine);
  }
};

}  // namespace plumbline::diagnose::test
