#pragma once
/// \file
/// Noise of a lab, simulated, for the tests of the diagnosis.

#include <cmath>
#include <random>
#include <vector>

#include "diagnose/inference/measurements.hpp"

namespace plumbline::diagnose::test {

/// Runs under an imposed end point of which only the layout matters: all readings are zero.
inline Experiment blank_experiment(const std::vector<std::size_t>& readings) {
  Experiment experiment{{{0.2, 0.2}, {1, 1}, {0, 0}, {0, 0}, {}, {}},
                        "blank",
                        {Bench::Plane::unknown, {0, 0}, false},
                        {0, 0, 1, 1, 0},
                        {}};
  for (const std::size_t count : readings) {
    Run run{"run-" + std::to_string(experiment.runs.size() + 1), Control::end_point, {0, 0}, {}};
    for (std::size_t i = 0; i < count; ++i) run.readings.push_back({static_cast<double>(i), {0.3, 0, 0, 0}});
    experiment.runs.push_back(run);
  }
  return experiment;
}

/// \param correlation  of neighbours
inline VectorXd correlated_noise(const Measurements& measurements, double scale, double correlation,
                                 std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  VectorXd noise(static_cast<Eigen::Index>(measurements.size()));
  for (const Series& series : measurements.series()) {
    double state = normal(random);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      noise(static_cast<Eigen::Index>(series.first + i)) = scale * state;
      state = correlation * state + std::sqrt(1 - correlation * correlation) * normal(random);
    }
  }
  return noise;
}

}  // namespace plumbline::diagnose::test
