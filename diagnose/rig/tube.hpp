#pragma once
/// \file
/// A round tube that bends.

#include <plumbline/arm/serial_arm.hpp>

namespace plumbline::diagnose {

/// Twist of the end of a round tube that bends and twists along a vector, by a wrench there: EI = 1 /
/// flexibility, GJ = EI / 1.3.
inline Matrix6<double> tube_compliance(const Vector3<double>& along, double flexibility) {
  const double length = along.norm();
  const Vector3<double> axis = along / length;
  const Eigen::Matrix3d beside = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  Eigen::Matrix3d cross;  // (cross F) = axis x F
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  constexpr double twist = 1.3;
  Matrix6<double> all;
  all.topLeftCorner<3, 3>() = length * length * length / 3 * beside;
  all.bottomLeftCorner<3, 3>() = length * length / 2 * cross;
  all.topRightCorner<3, 3>() = -length * length / 2 * cross;
  all.bottomRightCorner<3, 3>() = length * (beside + twist * axis * axis.transpose());
  const Matrix6<double> compliance = flexibility * all;
  return (compliance + compliance.transpose()) / 2;  // to the last bit
}

/// The same twist of a frame that the end carries, by a wrench there.
/// \param beyond  its place from the end, in the same axes
inline Matrix6<double> carried_on(const Matrix6<double>& compliance, const Vector3<double>& beyond) {
  Matrix6<double> wrench = Matrix6<double>::Identity();  // at the end, by that beyond
  wrench.bottomLeftCorner<3, 3>() << 0, -beyond.z(), beyond.y(), beyond.z(), 0, -beyond.x(), -beyond.y(),
      beyond.x(), 0;
  const Matrix6<double> carried = wrench.transpose() * compliance * wrench;
  return (carried + carried.transpose()) / 2;  // to the last bit
}

}  // namespace plumbline::diagnose
