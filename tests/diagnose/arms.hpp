#pragma once
/// \file
/// Experiments made up for the tests of arms in space: two arms of public shape, poses, weights, a tracker.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "diagnose/bench/read_arm.hpp"
#include "diagnose/inference/study.hpp"
#include "tests/diagnose/bench.hpp"

namespace plumbline::diagnose::test {

/// Adds a link behind the last one: its frame by place and fixed-axis angles.
inline void add_link(NominalArm& nominal, const Vector3<double>& place, const Vector3<double>& angles,
                     const Vector3<double>& axis, double stiffness, double mass,
                     const Vector3<double>& centre) {
  ArmLink<double> link;
  link.frame.translation() = place;
  link.frame.linear() = (Eigen::AngleAxisd(angles.z(), Vector3<double>::UnitZ()) *
                         Eigen::AngleAxisd(angles.y(), Vector3<double>::UnitY()) *
                         Eigen::AngleAxisd(angles.x(), Vector3<double>::UnitX()))
                            .toRotationMatrix();
  link.axis = axis;
  link.joint_compliance = stiffness > 0 ? 1 / stiffness : 0;
  link.mass = mass;
  link.centre = centre;
  nominal.arm.links.push_back(link);
  const std::string number = std::to_string(nominal.arm.size());
  nominal.joint.push_back("joint_" + number);
  nominal.link.push_back("link_" + number);
  nominal.limits.push_back({-2.9, 2.9});
}

/// Six axes with the lengths of a small industrial arm (ABB IRB 120: 290, 270, 70, 302, 72 mm).
/// \param stiffness  of joints 1 to 3, N m/rad; a third of it at the wrist; 0 is rigid
inline NominalArm industrial_arm(double stiffness = 3e4) {
  NominalArm arm;
  arm.base = "base", arm.tip = "tool";
  const Vector3<double> none(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  add_link(arm, none, none, z, stiffness, 3.1, {0, 0, 0.15});
  add_link(arm, {0, 0, 0.290}, none, y, stiffness, 3.9, {0, 0, 0.1});
  add_link(arm, {0, 0, 0.270}, none, y, stiffness, 2.9, {0, 0, 0.06});
  add_link(arm, {0, 0, 0.070}, none, x, stiffness / 3, 1.3, {0.22, 0, 0});
  add_link(arm, {0.302, 0, 0}, none, y, stiffness / 3, 0.6, none);
  add_link(arm, {0.072, 0, 0}, none, x, stiffness / 3, 0.2, none);
  arm.arm.tip.translation() = Vector3<double>(0.10, 0.03, 0.05);
  return arm;
}

/// Seven axes with the lengths of a collaborative arm (Franka Emika Panda: 333, 316, 82.5, 384, 88, 107 mm).
inline NominalArm collaborative_arm(double stiffness = 1e4) {
  NominalArm arm;
  arm.base = "link0", arm.tip = "flange";
  const double q = std::acos(0.0);
  const Vector3<double> none(0, 0, 0), z(0, 0, 1), up(q, 0, 0), down(-q, 0, 0);
  add_link(arm, {0, 0, 0.333}, none, z, stiffness, 4.97, {0, -0.03, -0.05});
  add_link(arm, none, down, z, stiffness, 0.65, {0, -0.07, 0.03});
  add_link(arm, {0, -0.316, 0}, up, z, stiffness, 3.23, {0.03, 0.04, -0.06});
  add_link(arm, {0.0825, 0, 0}, up, z, stiffness, 3.59, {-0.05, 0.10, 0.03});
  add_link(arm, {-0.0825, 0.384, 0}, down, z, stiffness / 2, 1.23, {-0.01, 0.04, -0.04});
  add_link(arm, none, up, z, stiffness / 2, 1.67, {0.06, -0.01, -0.01});
  add_link(arm, {0.088, 0, 0}, up, z, stiffness / 2, 0.74, {0.01, 0, 0.08});
  arm.arm.tip.translation() = Vector3<double>(0.02, 0.03, 0.107);
  return arm;
}

/// What is measured beside the places of the tip.
struct Measured {
  bool turns = false, angles = false, torques = false;
};

/// Poses anywhere about a bent one, half of them with a weight at the tip.
inline Experiment arm_bench(const NominalArm& arm, std::size_t readings, const Measured& measured = {},
                            unsigned seed = 1) {
  Experiment experiment;
  static_cast<NominalChain&>(experiment) = chain_of(arm);
  experiment.name = "arm";
  experiment.bench = {Bench::Plane::vertical, {0, 0}, false};
  experiment.noise = {0, 0, 0, 0, measured.angles ? 2e-5 : 0.0};
  experiment.noise[Channel::Name::place] = 3e-5, experiment.noise[Channel::Name::turn] = 1e-4,
  experiment.noise[Channel::Name::drive] = 0.1;
  const OnLink<double> tip{arm.arm.size() - 1, arm.arm.tip};
  experiment.arm_bench = {{{"tip", tip}}, tip};
  std::mt19937 engine(seed);
  const auto uniform = [&] { return 2 * static_cast<double>(engine()) / 4294967295.0 - 1; };
  std::vector<std::vector<double>> poses(readings / 2, std::vector<double>(arm.arm.size()));
  for (std::vector<double>& pose : poses)
    for (std::size_t j = 0; j < pose.size(); ++j) pose[j] = (j % 2 == 0 ? 0.0 : 0.6) + 1.2 * uniform();
  for (const double weight : {0.0, 3.0}) {
    Run run{weight > 0 ? "loaded" : "unloaded", Control::force, poses.front(), {}};
    run.by_weights = true;
    run.device = experiment.device;
    run.points = 1;
    for (const std::vector<double>& pose : poses) {
      Reading reading{static_cast<double>(30 * run.readings.size()), {std::nan(""), std::nan(""), 0, 0}};
      reading.rest = pose;
      reading.wrench = {0, 0, -9.81 * weight, 0, 0, 0};
      using Name = Channel::Name;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Channel(Name::place, axis, pose.size()).in(reading) = 0;
        Channel(Name::turn, axis, pose.size()).in(reading) = measured.turns ? 0 : std::nan("");
      }
      for (std::size_t j = 0; j < pose.size(); ++j) {
        if (measured.angles) Channel(Name::q, j).in(reading) = 0;
        if (measured.torques) Channel(Name::drive, j, pose.size()).in(reading) = 0;
      }
      run.readings.push_back(std::move(reading));
    }
    experiment.runs.push_back(std::move(run));
  }
  return experiment;
}

/// The experiment as the candidate would have given it, with noise of the declared sigma.
inline Experiment as_given(Experiment experiment, const Candidate& truth,
                           const std::vector<double>& parameters, unsigned seed) {
  const Prediction predicted = predict(Study(experiment), truth, parameters);
  REQUIRE(predicted.reached);
  std::mt19937 engine(seed);
  std::normal_distribution<double> normal;
  for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
    Run& run = experiment.runs[r];
    const std::vector<Channel> measured = run.measured();
    for (std::size_t i = 0; i < run.readings.size(); ++i)
      for (const Channel& channel : measured)
        if (double& value = channel.in(run.readings[i]); std::isfinite(value))
          value = predicted.runs[r](static_cast<Eigen::Index>(i), channel.column) +
                  channel.sigma(experiment.noise) * normal(engine);
  }
  return experiment;
}

}  // namespace plumbline::diagnose::test
