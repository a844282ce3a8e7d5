#pragma once
/// \file
/// The mass matrix of an arm by its composite bodies (Walker and Orin, 1982), its energy, and its
/// accelerations.

#include <Eigen/Cholesky>
#include <plumbline/dynamics/inverse_dynamics.hpp>

namespace plumbline {

/// Inertia of a body about the origin of the world: of a twist (velocity of the point at the origin, angular
/// velocity) it gives momentum and angular momentum.
template <Floating Real>
Matrix6<Real> inertia_in_world(const Real& mass, const Vector3<Real>& centre,
                               const Matrix3<Real>& about_centre) {
  Matrix3<Real> cross;
  cross << Real(0), -centre(2), centre(1), centre(2), Real(0), -centre(0), -centre(1), centre(0), Real(0);
  Matrix6<Real> inertia;
  inertia << mass * Matrix3<Real>::Identity(), -mass * cross, mass * cross,
      about_centre - mass * cross * cross;
  return inertia;
}

/// Symmetric and positive definite; kg m^2, kg m or kg.
template <Floating Real>
Matrix<Real> mass_matrix(const MovingArm<Real>& moving, const Vector<Real>& q) {
  const SerialArm<Real>& arm = moving.arm;
  const ArmPosture<Real> posture(arm, q);
  Matrix<Real> twist(6, q.size());  // of all beyond a joint, by its rate
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const ArmFreedom<Real>& joint = posture.freedoms()[static_cast<std::size_t>(k)];
    twist.col(k) << joint.velocity(Vector3<Real>::Zero()), joint.turning();
  }
  Matrix<Real> mass = moving.armature.asDiagonal();
  Matrix6<Real> beyond = Matrix6<Real>::Zero();
  for (Eigen::Index k = q.size(); k-- > 0;) {
    const auto i = static_cast<std::size_t>(k);
    const Pose<Real>& frame = posture.frame(i);
    beyond += inertia_in_world<Real>(arm.links[i].mass, frame * arm.links[i].centre,
                                     frame.linear() * moving.inertia[i] * frame.linear().transpose());
    const Vector6<Real> momentum = beyond * twist.col(k);
    for (Eigen::Index j = 0; j <= k; ++j) {
      const Real entry = twist.col(j).dot(momentum);
      mass(j, k) += entry;
      if (j < k) mass(k, j) += entry;
    }
  }
  return mass;
}

/// Kinetic energy, and that of the weights against the origin of the world, J.
template <Floating Real>
Real mechanical_energy(const MovingArm<Real>& moving, const ArmState<Real>& state) {
  const ArmPosture<Real> posture(moving.arm, state.q);
  Real energy = state.v.dot(mass_matrix(moving, state.q) * state.v) / 2;
  for (std::size_t i = 0; i < moving.arm.size(); ++i)
    energy -=
        moving.arm.links[i].mass * moving.arm.gravity.dot(posture.frame(i) * moving.arm.links[i].centre);
  return energy;
}

/// Accelerations of the joints under generalised forces of the drives, N m or N.
template <Floating Real>
Vector<Real> forward_dynamics(const MovingArm<Real>& moving, const ArmState<Real>& state,
                              const Vector<Real>& drive, const std::vector<ArmWrench<Real>>& wrenches = {}) {
  const Vector<Real> still = Vector<Real>::Zero(state.q.size());
  return mass_matrix(moving, state.q).llt().solve(drive - inverse_dynamics(moving, state, still, wrenches));
}

}  // namespace plumbline
