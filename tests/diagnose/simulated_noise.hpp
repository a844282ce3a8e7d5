#pragma once
/// \file
/// Noise of a lab, simulated, for the tests of the diagnosis.

#include <cmath>
#include <random>
#include <vector>

#include "diagnose/noise/noise.hpp"

/// Place of the load cell among the sensors.
inline constexpr auto at_force = plumbline::diagnose::place_of(plumbline::diagnose::Sensor::force);

/// Runs under an imposed end point of which only the layout matters: all readings are zero.
inline plumbline::diagnose::Experiment blank_experiment(const std::vector<std::size_t>& readings) {
  using namespace plumbline;
  using namespace plumbline::diagnose;
  Experiment experiment{{{0.2, 0.2}, {1, 1}, {0, 0}, {0, 0}, {}, {}},
                        "blank",
                        {Bench::Plane::unknown, {0, 0}, false},
                        {0, 0, 1, 1, 0},
                        {}};
  for (const std::size_t count : readings) {
    Run run{"run-" + std::to_string(experiment.runs.size() + 1), Control::end_point, {0, 0}, {}};
    for (std::size_t i = 0; i < count; ++i)
      run.readings.push_back({static_cast<double>(i), 0.3, 0, 0, 0, {}});
    experiment.runs.push_back(run);
  }
  return experiment;
}

/// \param by_sensor  correlation of neighbours
inline std::vector<double> correlated_noise(const plumbline::diagnose::Measurements& measurements,
                                            double scale, const plumbline::diagnose::BySensor& by_sensor,
                                            std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> noise(measurements.size());
  for (const plumbline::diagnose::Series& series : measurements.series()) {
    const double correlation = plumbline::diagnose::of(series.channel, by_sensor);
    double state = normal(random);
    for (std::size_t i = 0; i < series.readings.size(); ++i) {
      noise[series.first + i] = scale * state;
      state = correlation * state + std::sqrt(1 - correlation * correlation) * normal(random);
    }
  }
  return noise;
}

inline std::vector<double> correlated_noise(const plumbline::diagnose::Measurements& measurements,
                                            double scale, double correlation, std::mt19937_64& random) {
  return correlated_noise(measurements, scale, {correlation, correlation, correlation}, random);
}

inline void add_outliers(std::vector<double>& noise, double share, double size, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform;
  for (double& value : noise)
    if (uniform(random) < share) value += uniform(random) < 0.5 ? size : -size;
}
