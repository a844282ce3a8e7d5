#pragma once
/// \file
/// The forces that a motion asks of the drives: recursive Newton-Euler (Luh, Walker and Paul, 1980), in the
/// world.

#include <plumbline/dynamics/moving_arm.hpp>

namespace plumbline {

/// The motion of a link's frame, in the world.
template <Floating Real>
struct LinkMotion {
  Vector3<Real> turning = Vector3<Real>::Zero();       ///< angular velocity, rad/s
  Vector3<Real> spin = Vector3<Real>::Zero();          ///< angular acceleration, rad/s^2
  Vector3<Real> acceleration = Vector3<Real>::Zero();  ///< of its origin, m/s^2

  /// Acceleration of a point that the link carries.
  /// \param from  the origin of its frame, to the point, m
  [[nodiscard]] Vector3<Real> at(const Vector3<Real>& from) const {
    return acceleration + spin.cross(from) + turning.cross(turning.cross(from));
  }
  /// Of the link behind a joint whose freedom has rate v and acceleration a.
  /// \param way  from the origin of this frame to that of the next, m
  [[nodiscard]] LinkMotion behind(const ArmFreedom<Real>& joint, const Vector3<Real>& way, const Real& v,
                                  const Real& a) const {
    LinkMotion next{turning, spin, at(way)};
    if (joint.kind == JointKind::prismatic) {
      next.acceleration += a * joint.axis + 2 * v * turning.cross(joint.axis);
    } else {
      next.turning += v * joint.axis;
      next.spin += a * joint.axis + v * turning.cross(joint.axis);
    }
    return next;
  }
};

/// Generalised forces of the drives, N m or N: M(q) a + c(q, v) - gravity, with the rotors' part.
/// \param a  accelerations of the joints
/// \param wrenches  of the environment on the arm
template <Floating Real>
Vector<Real> inverse_dynamics(const MovingArm<Real>& moving, const ArmState<Real>& state,
                              const Vector<Real>& a, const std::vector<ArmWrench<Real>>& wrenches = {}) {
  const SerialArm<Real>& arm = moving.arm;
  const ArmPosture<Real> posture(arm, state.q);
  std::vector<Vector3<Real>> force(arm.size()), moment(arm.size());  // that a link takes, about its origin
  LinkMotion<Real> motion;
  Vector3<Real> before = arm.base.translation();
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Pose<Real>& frame = posture.frame(i);
    motion = motion.behind(posture.freedoms()[i], frame.translation() - before, state.v(k), a(k));
    before = frame.translation();
    const Vector3<Real> centre = frame.linear() * arm.links[i].centre;
    force[i] = arm.links[i].mass * (motion.at(centre) - arm.gravity);
    const Matrix3<Real> inertia = frame.linear() * moving.inertia[i] * frame.linear().transpose();
    moment[i] =
        inertia * motion.spin + motion.turning.cross(inertia * motion.turning) + centre.cross(force[i]);
  }
  for (const ArmWrench<Real>& one : wrenches) {
    force[one.at.link] -= one.force;
    const Vector3<Real> from = posture.of(one.at).translation() - posture.frame(one.at.link).translation();
    moment[one.at.link] -= one.moment + from.cross(one.force);
  }
  Vector<Real> drive(state.q.size());
  for (std::size_t i = arm.size(); i-- > 0;) {
    const auto k = static_cast<Eigen::Index>(i);
    const ArmFreedom<Real>& joint = posture.freedoms()[i];
    drive(k) =
        joint.axis.dot(joint.kind == JointKind::prismatic ? force[i] : moment[i]) + moving.armature(k) * a(k);
    if (i == 0) break;
    const Vector3<Real> way = posture.frame(i).translation() - posture.frame(i - 1).translation();
    force[i - 1] += force[i];
    moment[i - 1] += moment[i] + way.cross(force[i]);
  }
  return drive;
}

}  // namespace plumbline
