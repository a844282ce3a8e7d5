#pragma once
/// \file
/// Generalised forces of gravity and of wrenches on the freedoms of an arm, and their derivatives.

#include <plumbline/arm/arm_kinematics.hpp>

namespace plumbline {

/// A wrench on a point that a link carries. Its force and moment keep their direction in the world.
template <Floating Real>
struct ArmWrench {
  OnLink<Real> at;                               ///< the point
  Vector3<Real> force = Vector3<Real>::Zero();   ///< N
  Vector3<Real> moment = Vector3<Real>::Zero();  ///< N m
};

/// What acts beyond a freedom: forces F at points p, and moments.
template <Floating Real>
struct LoadBeyond {
  Vector3<Real> force = Vector3<Real>::Zero();                         ///< sum of the forces, N
  Vector3<Real> moment = Vector3<Real>::Zero();                        ///< sum of the moments, N m
  Eigen::Matrix<Real, 3, 3> dyad = Eigen::Matrix<Real, 3, 3>::Zero();  ///< sum of p F'

  /// Adds a force at a point.
  void add(const Vector3<Real>& f, const Vector3<Real>& at) {
    force += f;
    dyad += at * f.transpose();
  }
  /// Moment of all about the origin of the world.
  [[nodiscard]] Vector3<Real> about_origin() const {
    return moment + Vector3<Real>(dyad(1, 2) - dyad(2, 1), dyad(2, 0) - dyad(0, 2), dyad(0, 1) - dyad(1, 0));
  }
};

/// Generalised forces on all freedoms, and their derivatives by the coordinates, a row a force.
template <Floating Real>
struct ArmLoads {
  Vector<Real> force;      ///< N m or N, one a freedom
  Matrix<Real> stiffness;  ///< its derivatives
};

/// Calls `visit(k, freedom, beyond)` with the loads beyond each freedom, from the last to the first.
template <Floating Real, class Visit>
void for_loads_beyond(const SerialArm<Real>& arm, const ArmPosture<Real>& posture,
                      const std::vector<ArmWrench<Real>>& wrenches, Visit visit) {
  const std::vector<ArmFreedom<Real>>& freedom = posture.freedoms();
  std::vector<LoadBeyond<Real>> carried(freedom.size() + 1);  // by what so many freedoms move
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmLink<Real>& link = arm.links[i];
    const std::size_t near = posture.moved_by(i) - (i + 1 == arm.size() && yields(link) ? 6 : 0);
    carried[near].add(link.mass * arm.gravity, posture.frame(i) * link.centre);
    if (link.far_mass != Real(0))
      carried[near + (yields(link) ? 6 : 0)].add(link.far_mass * arm.gravity,
                                                 posture.far_frame(i) * link.far_centre);
  }
  for (const ArmWrench<Real>& one : wrenches) {
    LoadBeyond<Real>& load = carried[posture.moved_by(one.at.link)];
    load.add(one.force, posture.of(one.at).translation());
    load.moment += one.moment;
  }
  LoadBeyond<Real> beyond;
  for (std::size_t k = freedom.size(); k-- > 0;) {
    const LoadBeyond<Real>& here = carried[k + 1];
    beyond.force += here.force;
    beyond.moment += here.moment;
    beyond.dyad += here.dyad;
    visit(static_cast<Eigen::Index>(k), freedom[k], beyond);
  }
}

/// Generalised force of what is beyond a freedom, N m or N.
template <Floating Real>
Real force_on(const ArmFreedom<Real>& freedom, const LoadBeyond<Real>& beyond) {
  return freedom.kind == JointKind::prismatic
             ? freedom.axis.dot(beyond.force)
             : freedom.axis.dot(beyond.about_origin() - freedom.origin.cross(beyond.force));
}

/// Generalised forces on all freedoms.
template <Floating Real>
Vector<Real> arm_forces(const SerialArm<Real>& arm, const ArmPosture<Real>& posture,
                        const std::vector<ArmWrench<Real>>& wrenches) {
  Vector<Real> force(static_cast<Eigen::Index>(posture.freedoms().size()));
  for_loads_beyond(arm, posture, wrenches,
                   [&](Eigen::Index k, const ArmFreedom<Real>& one, const LoadBeyond<Real>& beyond) {
                     force(k) = force_on(one, beyond);
                   });
  return force;
}

/// The same with their derivatives. Moments have no potential: their part of the derivatives is not
/// symmetric.
template <Floating Real>
ArmLoads<Real> arm_loads(const SerialArm<Real>& arm, const ArmPosture<Real>& posture,
                         const std::vector<ArmWrench<Real>>& wrenches) {
  const std::vector<ArmFreedom<Real>>& freedom = posture.freedoms();
  const auto n = static_cast<Eigen::Index>(freedom.size());
  ArmLoads<Real> loads{Vector<Real>(n), Matrix<Real>::Zero(n, n)};
  for_loads_beyond(
      arm, posture, wrenches,
      [&](Eigen::Index k, const ArmFreedom<Real>& one, const LoadBeyond<Real>& beyond) {
        loads.force(k) = force_on(one, beyond);
        const bool slides = one.kind == JointKind::prismatic;
        // Sum of J_k x F over what is beyond: of (a x r) x F = r (a . F) - a (r . F).
        const Eigen::Matrix<Real, 3, 3> about = beyond.dyad - one.origin * beyond.force.transpose();
        const Vector3<Real> turned = slides ? Vector3<Real>(one.axis.cross(beyond.force))
                                            : Vector3<Real>(about * one.axis - one.axis * about.trace());
        for (Eigen::Index i = 0; i <= k; ++i) {
          const ArmFreedom<Real>& before = freedom[static_cast<std::size_t>(i)];
          if (before.kind == JointKind::prismatic) continue;
          loads.stiffness(i, k) = loads.stiffness(k, i) = before.axis.dot(turned);
          if (!slides && i < k) loads.stiffness(k, i) += before.axis.cross(one.axis).dot(beyond.moment);
        }
      });
  return loads;
}

/// Moment of all loads about the origin of the base, in the world, N m.
template <Floating Real>
Vector3<Real> moment_on_base(const SerialArm<Real>& arm, const ArmPosture<Real>& posture,
                             const std::vector<ArmWrench<Real>>& wrenches) {
  LoadBeyond<Real> all;
  for (std::size_t i = 0; i < arm.size(); ++i) {
    all.add(arm.links[i].mass * arm.gravity, posture.frame(i) * arm.links[i].centre);
    if (arm.links[i].far_mass != Real(0))
      all.add(arm.links[i].far_mass * arm.gravity, posture.far_frame(i) * arm.links[i].far_centre);
  }
  for (const ArmWrench<Real>& one : wrenches) {
    all.add(one.force, posture.of(one.at).translation());
    all.moment += one.moment;
  }
  return all.about_origin() - arm.base.translation().cross(all.force);
}

}  // namespace plumbline
