#pragma once
/// \file
/// A round tube in a link: how its end yields, and how the link's own weight loads that end.

#include <algorithm>
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

/// The same of a bar that stretches, by a strain for each newton along it.
inline Matrix6<double> bar_compliance(const Vector3<double>& along, double strain) {
  Matrix6<double> all = Matrix6<double>::Zero();
  all.topLeftCorner<3, 3>() = strain / along.norm() * along * along.transpose();
  return all;
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

/// How the mass of a link lies along it, where a model says no more than its centre: evenly, and what is then
/// off the middle, a motor say, at the nearer end. So it is where a payload hangs at the end of an even link.
struct Lying {
  double centre;  ///< share of the length, from 0 to 1
  double even;    ///< share of the mass that lies evenly

  /// \param share  of the length, where the centre is; beyond the ends a body sits rigidly at the end
  explicit Lying(double share)
      : centre(std::clamp(share, 0.0, 1.0)), even(2 * std::min(centre, 1 - centre)) {}
  /// The share of the weight that a cross-section carries. \param share  of the length, where it is
  [[nodiscard]] double carried(double share) const { return centre - even * (share - 0.5); }
};

/// Parts the mass of a link between the ends of what yields in it, so that they move by its own weight as
/// those of an elastic beam do.
///
/// A weight at a share s moves with the beam's cubic shape: its virtual work is that of the forces (3 s^2 - 2
/// s^3) W across, s W along and the moment (s^3 - s^2) W L at the far end. Over the length an even weight
/// gives W / 2, W / 2 and -W L / 12: the end sags by W L^3 / (8 EI), turns by W L^2 / (6 EI) and gives way by
/// W L / (2 EA), as it should. One at an end gives all or nothing. So the far end bears the share t of the
/// centre, in a point that is `even` L / (12 t) before it, and what is left keeps the centre.
/// \param from, to  ends of what yields, in the frame of the link
inline void part_mass(ArmLink<double>& link, const Vector3<double>& from, const Vector3<double>& to) {
  const Vector3<double> along = to - from;
  const Lying lying((link.centre - from).dot(along) / along.squaredNorm());
  const double far = lying.centre, near = 1 - far;
  const Vector3<double> off = link.centre - from - far * along;  // rigidly beside it
  link.far_mass = far * link.mass;
  link.far_centre = to + off - std::min(1.0, near / far) / 6 * along;
  link.mass *= near;
  link.centre = from + off + std::min(1.0, far / near) / 6 * along;
}

}  // namespace plumbline::diagnose
