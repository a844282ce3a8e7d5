#pragma once
/// \file
/// Experiments made up for the tests: a finger of three links whose joints a tendon turns.

#include <cmath>
#include <vector>

#include "tests/diagnose/bench.hpp"
#include "tests/diagnose/chain_values.hpp"

namespace plumbline::diagnose::test {

inline const std::vector<double> finger_rest{0.1, 0.15, 0.2};
inline const std::vector<double> finger_radius{0.012, 0.010, 0.008};

/// Loads along a chain, with the names of their values, as the runs of the experiment have them too.
inline void set_loads(Experiment& experiment, std::vector<Load> loads, std::vector<std::string> names) {
  experiment.loads = std::move(loads);
  experiment.covariates = std::move(names);
  for (Run& run : experiment.runs)
    run.loads = load_channels(experiment.loads, experiment.link_length, experiment.covariates);
}

/// The tendon is pulled by these tensions, N, while nothing acts on the end point.
inline Experiment finger(const std::vector<double>& tensions) {
  Experiment experiment = three_links();
  experiment.name = "finger";
  experiment.joint_stiffness = {0.40, 0.30, 0.20};
  experiment.bench = {Bench::Plane::horizontal, {0, 0}, false};
  Run run{"bend", Control::force, finger_rest, {}};
  run.by_weights = true;
  for (const double tension : tensions) {
    run.readings.push_back(
        {2.0 * static_cast<double>(run.readings.size()), chain_values(0, 0, 0, 0, {0, 0, 0})});
    run.readings.back().covariates = {tension};
  }
  experiment.runs = {run};
  set_loads(experiment, {{Load::Kind::tendon, 0, finger_radius}}, {"tension"});
  return experiment;
}

/// Tensions up to the largest and back to nothing.
inline std::vector<double> there_and_back(double largest, int steps) {
  std::vector<double> tensions;
  for (int i = 0; i <= 2 * steps; ++i)
    tensions.push_back(largest * (1 - std::abs(1 - static_cast<double>(i) / steps)));
  return tensions;
}

}  // namespace plumbline::diagnose::test
