#pragma once
/// \file
/// A hinge on a rig, whose torque may be anything of its deflection.

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose::test {

inline constexpr double hinge_stiffness = 50, lever = 0.2, force_noise = 0.1;

/// A hinge on a rig that leads a rod, which pushes along x, by its end: its angle is known from the end point
/// and its torque from the force alone, T = -lever sin(q) Fx.
/// \param torque  at the hinge by deflection,
/// called in the order of the readings of a run
inline Experiment hinge(const std::vector<std::vector<double>>& deflections,
                        const std::function<std::function<double(double)>()>& torque, unsigned seed) {
  Experiment experiment;
  experiment.name = "hinge";
  experiment.link_length = {lever, lever};
  experiment.joint_stiffness = {hinge_stiffness, 0};
  experiment.link_mass = {0, 0};
  experiment.gravity = {0, 0};
  experiment.bench = {Bench::Plane::horizontal, {0, 0}, false};
  experiment.noise = {0, 0, force_noise, force_noise, 0};
  const double rest = std::acos(0.0);
  std::mt19937 engine(seed);
  std::normal_distribution<double> noise(0, force_noise);
  for (const std::vector<double>& path : deflections) {
    Run run{"run-" + std::to_string(experiment.runs.size() + 1), Control::end_point, {rest, -rest}, {}};
    const auto carried = torque();
    for (const double d : path) {
      const double height = lever * std::sin(rest + d);
      run.readings.push_back(
          {static_cast<double>(run.readings.size()),
           {lever * (1 + std::cos(rest + d)), height, noise(engine) - carried(d) / height, noise(engine)}});
    }
    experiment.runs.push_back(run);
  }
  return experiment;
}

/// 0 to `far` to `back` to 0, in even steps.
inline std::vector<double> cycle(double far, double back) {
  std::vector<double> path;
  constexpr double step = 0.01;
  const auto go = [&](double to) {
    const double from = path.empty() ? 0 : path.back();
    const int count = static_cast<int>(std::lround(std::abs(to - from) / step));
    for (int i = path.empty() ? 0 : 1; i <= count; ++i) path.push_back(from + (to - from) * i / count);
  };
  go(far);
  go(back);
  go(0);
  return path;
}

}  // namespace plumbline::diagnose::test
