#pragma once
/// \file
/// Poses of a serial arm, and how they change with its freedoms.
///
/// A freedom is one coordinate: of a joint, or one of the six at the far end of a link that yields: three
/// translations, then three rotations along its axes (a virtual-joint model). Freedom k moves a point p
/// beyond it by J_k = a_k x (p - o_k), or by a_k where it slides; for i before k the second derivative of p
/// is a_i x J_k where i turns, and zero where it slides.

#include <plumbline/arm/serial_arm.hpp>

namespace plumbline {

/// The motion of a joint at a coordinate, in the frame of its link.
template <Floating Real>
Pose<Real> joint_motion(JointKind kind, const Vector3<Real>& axis, const Real& coordinate) {
  Pose<Real> by = Pose<Real>::Identity();
  if (kind == JointKind::prismatic)
    by.translation() = coordinate * axis;
  else
    by.linear() = Eigen::AngleAxis<Real>(coordinate, axis).toRotationMatrix();
  return by;
}

/// A freedom at one posture of the arm, in the world.
template <Floating Real>
struct ArmFreedom {
  JointKind kind;        ///< whether it turns or slides
  std::size_t link;      ///< that it moves, or whose far end it is of
  bool of_joint;         ///< else of the far end
  Vector3<Real> axis;    ///< unit vector
  Vector3<Real> origin;  ///< a point on the axis, m

  /// Velocity of a point beyond it, by its rate.
  [[nodiscard]] Vector3<Real> velocity(const Vector3<Real>& point) const {
    return kind == JointKind::prismatic ? axis : Vector3<Real>(axis.cross(point - origin));
  }
  /// Angular velocity of what is beyond it, by its rate.
  [[nodiscard]] Vector3<Real> turning() const {
    return kind == JointKind::prismatic ? Vector3<Real>(Vector3<Real>::Zero()) : axis;
  }
};

/// Whether a link yields at all: a compliance whose diagonal is zero is zero, for no wrench gives work back.
template <Floating Real>
bool yields(const ArmLink<Real>& link) {
  return !link.compliance.diagonal().isZero(Real(0));
}

/// Number of freedoms: joints, and six for each link that yields.
template <Floating Real>
std::size_t freedoms(const SerialArm<Real>& arm) {
  std::size_t count = arm.size();
  for (const ArmLink<Real>& link : arm.links) count += yields(link) ? 6 : 0;
  return count;
}

/// A point or frame that a link carries.
template <Floating Real>
struct OnLink {
  std::size_t link;                           ///< from 0
  Pose<Real> frame = Pose<Real>::Identity();  ///< in that of the link

  /// Whether link and frame are the same.
  friend bool operator==(const OnLink& a, const OnLink& b) {
    return a.link == b.link && a.frame.matrix() == b.frame.matrix();
  }
};

/// A posture: the frames of all links, and the freedoms from the base on.
template <Floating Real>
class ArmPosture {
 public:
  /// \param coordinate  of all freedoms, in their order: each joint's, behind it those of its link's far end
  ArmPosture(const SerialArm<Real>& arm, const Vector<Real>& coordinate) {
    Pose<Real> at = arm.base;
    Eigen::Index next = 0;
    frame_.reserve(arm.size());
    far_frame_.reserve(arm.size());
    freedom_.reserve(static_cast<std::size_t>(coordinate.size()));
    for (std::size_t i = 0; i < arm.size(); ++i) {
      const ArmLink<Real>& link = arm.links[i];
      at = at * link.frame;
      move(at, link.kind, i, true, link.axis, coordinate(next++));
      frame_.push_back(at);
      if (yields(link)) {
        const Pose<Real>& end = arm.far_end(i);
        at = at * Eigen::Translation<Real, 3>(end.translation());
        for (const JointKind kind : {JointKind::prismatic, JointKind::revolute})
          for (Eigen::Index axis = 0; axis < 3; ++axis)
            move(at, kind, i, false, Vector3<Real>::Unit(axis), coordinate(next++));
        at = at * Eigen::Translation<Real, 3>(-end.translation());
      }
      far_frame_.push_back(at);
    }
  }

  /// The frame of a link, before its far end yields.
  [[nodiscard]] const Pose<Real>& frame(std::size_t link) const { return frame_[link]; }
  /// The same as the far end moves it, where the link yields.
  [[nodiscard]] const Pose<Real>& far_frame(std::size_t link) const { return far_frame_[link]; }
  /// A frame that a link carries, in the world. On the last link it yields with the far end.
  [[nodiscard]] Pose<Real> of(const OnLink<Real>& one) const {
    return (one.link + 1 < frame_.size() ? frame_ : far_frame_)[one.link] * one.frame;
  }
  /// All freedoms, from the base on.
  [[nodiscard]] const std::vector<ArmFreedom<Real>>& freedoms() const { return freedom_; }
  /// Number of freedoms that move what a link carries: those before its far end, or all for the last link.
  [[nodiscard]] std::size_t moved_by(std::size_t link) const {
    std::size_t count = 0;
    for (const ArmFreedom<Real>& one : freedom_)
      count += one.link < link || (one.link == link && (one.of_joint || link + 1 == frame_.size()));
    return count;
  }

 private:
  void move(Pose<Real>& at, JointKind kind, std::size_t link, bool of_joint, const Vector3<Real>& axis,
            const Real& coordinate) {
    freedom_.push_back({kind, link, of_joint, at.linear() * axis, at.translation()});
    if (kind == JointKind::prismatic) {
      at.translation() += coordinate * freedom_.back().axis;
    } else {
      at.linear() = at.linear() * Eigen::AngleAxis<Real>(coordinate, axis).toRotationMatrix();
    }
  }

  std::vector<Pose<Real>> frame_, far_frame_;
  std::vector<ArmFreedom<Real>> freedom_;
};

/// Rotation vector of a rotation: its axis times its angle, from 0 to pi.
template <Floating Real>
Vector3<Real> rotation_vector(const Eigen::Matrix<Real, 3, 3>& rotation) {
  const Eigen::AngleAxis<Real> turn(rotation);
  return turn.angle() * turn.axis();
}

/// The rotation of a rotation vector.
template <Floating Real>
Eigen::Matrix<Real, 3, 3> rotation_by(const Vector3<Real>& vector) {
  const Real angle = vector.norm();
  if (angle == Real(0)) return Eigen::Matrix<Real, 3, 3>::Identity();
  return Eigen::AngleAxis<Real>(angle, vector / angle).toRotationMatrix();
}

}  // namespace plumbline
