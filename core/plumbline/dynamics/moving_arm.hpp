#pragma once
/// \file
/// A serial arm in motion: what its links and drives weigh against acceleration, and its state.

#include <Eigen/Eigenvalues>
#include <plumbline/arm/arm_loads.hpp>

namespace plumbline {

/// A 3 by 3 matrix.
template <Floating Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

/// A rigid arm and its inertias. SI units, radians; coordinates are in the order of the links.
template <Floating Real>
struct MovingArm {
  SerialArm<Real> arm;
  /// Of each link about its centre of mass, in the axes of the link, kg m^2.
  std::vector<Matrix3<Real>> inertia;
  /// Of each drive's rotor as its joint feels it, times the gear ratio squared, kg m^2 or kg.
  Vector<Real> armature;

  /// Point masses at the centres of the links, and drives without rotors.
  explicit MovingArm(SerialArm<Real> of)
      : arm(std::move(of)),
        inertia(arm.size(), Matrix3<Real>::Zero()),
        armature(Vector<Real>::Zero(static_cast<Eigen::Index>(arm.size()))) {}
};

/// Coordinates of the joints, rad or m, and their rates.
template <Floating Real>
struct ArmState {
  Vector<Real> q, v;
};

/// \throws Error where the arm is none (serial_arm.hpp), where a link yields, where an inertia is not that of a
///         body (symmetric, each principal moment at most the sum of the others), where an armature is
///         negative or no number, and where a joint moves nothing
template <Floating Real>
void require_physical(const MovingArm<Real>& moving) {
  require_physical(moving.arm);
  if (moving.inertia.size() != moving.arm.size() ||
      moving.armature.size() != static_cast<Eigen::Index>(moving.arm.size()))
    throw Error("inertias of the arm", "another number than links", "one inertia and one armature a link");
  Real beyond(0);
  for (std::size_t i = moving.arm.size(); i-- > 0;) {
    const std::string place = "link " + std::to_string(i + 1) + " of the arm";
    if (yields(moving.arm.links[i])) throw Error(place, "a link that yields", "rigid links between joints");
    const Matrix3<Real>& inertia = moving.inertia[i];
    const Vector3<Real> principal = Eigen::SelfAdjointEigenSolver<Matrix3<Real>>(inertia).eigenvalues();
    const Real rounding = 100 * epsilon<Real>() * principal.cwiseAbs().sum();
    if (!(inertia == inertia.transpose()) || !(principal(0) >= -rounding) ||
        !(principal(2) <= principal(0) + principal(1) + rounding))
      throw Error(place, "an inertia that no body has",
                  "a symmetric matrix whose principal moments are each at most the sum of the others");
    const Real armature = moving.armature(static_cast<Eigen::Index>(i));
    if (!(armature >= Real(0)) || !is_finite(armature))
      throw Error(place, "an armature that is negative or no number", "kg m^2 or kg, zero or positive");
    beyond += moving.arm.links[i].mass + principal.sum();
    if (!(beyond + armature > Real(0)))
      throw Error(place, "a joint that moves no mass", "a mass, an inertia or an armature");
  }
}

}  // namespace plumbline
