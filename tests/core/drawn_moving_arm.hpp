#pragma once
/// \file
/// Arms in motion, drawn at random: two to six joints of both kinds, each link a body.

#include <plumbline/dynamics/moving_arm.hpp>
#include <random>

#include "tests/property.hpp"

/// \param seed  the same arm for the same seed
inline plumbline::MovingArm<double> drawn_moving_arm_of(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Eigen::Vector3d(uniform(random), uniform(random), uniform(random)); };
  const auto rotation = [&] {
    return Eigen::AngleAxisd(3 * uniform(random), (vector() + Eigen::Vector3d(0, 0, 2)).normalized())
        .toRotationMatrix();
  };
  plumbline::SerialArm<double> arm;
  arm.base.translation() = vector();
  arm.base.linear() = rotation();
  arm.links.resize(2 + random() % 5);
  for (plumbline::ArmLink<double>& link : arm.links) {
    link.kind = uniform(random) < -0.4 ? plumbline::JointKind::prismatic : plumbline::JointKind::revolute;
    link.frame.translation() = vector();
    link.frame.linear() = rotation();
    link.axis = (vector() + Eigen::Vector3d(0, 2, 0)).normalized();
    link.mass = 1 + uniform(random) / 2;
    link.centre = 0.3 * vector();
  }
  arm.tip.translation() = vector();
  plumbline::MovingArm<double> moving(arm);
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const Eigen::Matrix3d axes = rotation();
    const Eigen::Vector3d radii =
        Eigen::Vector3d(0.3, 0.3, 0.3) + 0.2 * vector();  // of gyration, along three axes
    const Eigen::Vector3d squares = arm.links[i].mass * radii.cwiseAbs2();
    const Eigen::Vector3d moments(squares(1) + squares(2), squares(0) + squares(2), squares(0) + squares(1));
    const Eigen::Matrix3d inertia = axes * moments.asDiagonal() * axes.transpose();
    moving.inertia[i] = (inertia + inertia.transpose()) / 2;
    moving.armature(static_cast<Eigen::Index>(i)) = 0.05 * (1 + uniform(random));
  }
  return moving;
}

/// Coordinates from -1 to 1, rates from -2 to 2.
inline plumbline::ArmState<double> drawn_state_of(const plumbline::MovingArm<double>& moving, unsigned seed) {
  std::mt19937 random(seed + 1000);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto n = static_cast<Eigen::Index>(moving.arm.size());
  const auto draw = [&] { return uniform(random); };
  plumbline::ArmState<double> state;
  state.q = Eigen::VectorXd::NullaryExpr(n, draw);
  state.v = 2 * Eigen::VectorXd::NullaryExpr(n, draw);
  return state;
}

// inside properties
inline plumbline::MovingArm<double> drawn_moving_arm() {
  return drawn_moving_arm_of(*rc::gen::arbitrary<unsigned>());
}
inline plumbline::ArmState<double> drawn_state(const plumbline::MovingArm<double>& moving) {
  return drawn_state_of(moving, *rc::gen::arbitrary<unsigned>());
}
inline Eigen::VectorXd drawn_rates(const plumbline::MovingArm<double>& moving) {
  return drawn_state(moving).v;
}
