#pragma once
/// \file
/// An arm in space with the parameters of its effects. The laws of its joints are the rig's.

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Lists are by joint. Zero additions give the nominal model.
struct ArmRig {
  SerialArm<double> arm;  ///< with errors of geometry, masses and compliances

  // A joint whose encoder says q stands at (1 + scale) q + zero + ripple . (cos q, sin q).
  std::vector<double> zero, scale;
  std::vector<Eigen::Vector2d> ripple;
  /// Torque on the joint, of the cosine and the sine of its angle: of a counterweight or a spring, N m.
  std::vector<Eigen::Vector2d> balance;
  double expansion = 0;    ///< of all lengths, 1/K, from the temperature of the first reading on
  double compensated = 0;  ///< share of the nominal torque of gravity that the servos hold without yielding
  /// Turn of the base about its x and y by the moment on it, rad/(N m).
  Eigen::Vector2d mount_compliance = Eigen::Vector2d::Zero();
  // The tool tips about the origin of the last link, in the axes of that link.
  double tool_compliance = 0;  ///< by the moment on it, rad/(N m)
  double tool_play = 0;        ///< by as much as it can, in the direction of the moment, rad
  /// About this axis by as much as its length, to the side to which the moment turns it, rad.
  Vector3<double> tool_hinge = Vector3<double>::Zero();

  // Instruments.
  Pose<double> tracker = Pose<double>::Identity();  ///< the frame of the tracker, in the world
  double tracker_scale = 0;                         ///< it shows 1 + a times the distance from its origin
  std::vector<OnLink<double>> points;               ///< of the bench, with their errors
  OnLink<double> load{0};
  double wrench_scale = 0;                                ///< the sensor shows 1 + g times the wrench
  Vector6<double> wrench_bias = Vector6<double>::Zero();  ///< beside it, N and N m
  std::vector<double> angle_bias, angle_scale;            ///< of the angles that are read
  std::vector<double> torque_bias, torque_scale;          ///< of the torques that are read

  /// The arm and the bench of an experiment, without any error.
  static ArmRig nominal(const Experiment& experiment);
  /// Rotation vector of the tool in the axes of the last link.
  /// \param moment  on the tool, in these axes, N m
  [[nodiscard]] Vector3<double> tool_turn(const Vector3<double>& moment) const;
  /// By how much a joint stands off what its encoder says.
  [[nodiscard]] double encoder_error(std::size_t joint, double q) const {
    const double even = scale[joint] * q + zero[joint];
    if (ripple[joint].isZero(0)) return even;
    return even + ripple[joint].dot(Eigen::Vector2d(std::cos(q), std::sin(q)));
  }
  friend bool operator==(const ArmRig& a, const ArmRig& b);
};

}  // namespace plumbline::diagnose
