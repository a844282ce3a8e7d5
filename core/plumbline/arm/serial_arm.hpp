#pragma once
/// \file
/// A serial arm in space: links that revolute or prismatic joints move, with masses and compliances.
///
/// \code{.cpp}
/// SerialArm<double> pendulum;
/// pendulum.links.resize(1);
/// pendulum.links[0].axis = {0, 1, 0};
/// pendulum.links[0].mass = 2;
/// pendulum.links[0].centre = {0.5, 0, 0};
/// pendulum.tip.translation() = Eigen::Vector3d(1, 0, 0);
/// require_physical(pendulum);
/// \endcode

#include <Eigen/Geometry>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <plumbline/base/number.hpp>
#include <string>
#include <vector>

namespace plumbline {

/// A point or a vector, x, y, z.
template <Floating Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;
/// Of a twist: translation, then rotation; of a wrench: force, then moment.
template <Floating Real>
using Vector6 = Eigen::Matrix<Real, 6, 1>;
/// Of a twist by a wrench: a compliance, or the reverse: a stiffness.
template <Floating Real>
using Matrix6 = Eigen::Matrix<Real, 6, 6>;
/// A rigid motion: the frame that it is of, in the frame that it is in.
template <Floating Real>
using Pose = Eigen::Transform<Real, 3, Eigen::Isometry>;

/// The motions of a joint.
enum class JointKind {
  revolute,  ///< turns about its axis
  prismatic  ///< slides along it
};

/// A link and the joint that moves it against the link before, the first against the base.
template <Floating Real>
struct ArmLink {
  JointKind kind = JointKind::revolute;  ///< of the joint
  /// Of the link at joint coordinate zero, in the frame of the link before, or of the base. The joint's axis
  /// goes through its origin.
  Pose<Real> frame = Pose<Real>::Identity();
  Vector3<Real> axis{Real(0), Real(0), Real(1)};  ///< unit vector, in the link's frame
  Real joint_compliance{0};  ///< rad/(N m) or m/N: the joint yields so much beyond its command; 0 is rigid
  Real mass{0};              ///< kg
  Vector3<Real> centre = Vector3<Real>::Zero();  ///< of mass, in the link's frame, m
  Real far_mass{0};                              ///< kg, beside it: moves with the far end as the link yields
  Vector3<Real> far_centre = Vector3<Real>::Zero();  ///< of that mass, in the link's frame, m
  /// Twist of the link's far end by a wrench there, in the axes of the link: m/N, rad/(N m). The far end is
  /// the origin of the next link's frame, or the tip. Symmetric; zero is rigid.
  Matrix6<Real> compliance = Matrix6<Real>::Zero();

  /// Whether all numbers are the same.
  friend bool operator==(const ArmLink& a, const ArmLink& b) {
    return a.kind == b.kind && a.frame.matrix() == b.frame.matrix() && a.axis == b.axis &&
           a.joint_compliance == b.joint_compliance && a.mass == b.mass && a.centre == b.centre &&
           a.far_mass == b.far_mass && a.far_centre == b.far_centre && a.compliance == b.compliance;
  }
};

/// SI units, radians. Joint coordinates are in the order of the links.
template <Floating Real>
struct SerialArm {
  Pose<Real> base = Pose<Real>::Identity();                         ///< in the world
  Vector3<Real> gravity{Real(0), Real(0), Real(-981) / Real(100)};  ///< acceleration, in the world
  std::vector<ArmLink<Real>> links;                                 ///< from the base on
  Pose<Real> tip = Pose<Real>::Identity();                          ///< in the frame of the last link

  /// Number of links, and of joints.
  [[nodiscard]] std::size_t size() const { return links.size(); }
  /// The far end of a link, in its frame: the next link's frame, or the tip.
  [[nodiscard]] const Pose<Real>& far_end(std::size_t link) const {
    return link + 1 < size() ? links[link + 1].frame : tip;
  }
  /// Whether all numbers are the same.
  friend bool operator==(const SerialArm& a, const SerialArm& b) {
    return a.base.matrix() == b.base.matrix() && a.gravity == b.gravity && a.links == b.links &&
           a.tip.matrix() == b.tip.matrix();
  }
};

/// \throws Error where the arm has no link, or one whose axis is no unit vector, or whose mass or compliance is
///         negative or no number
template <Floating Real>
void require_physical(const SerialArm<Real>& arm) {
  using std::abs;
  if (arm.links.empty()) throw Error("arm", "no link", "one or more");
  for (std::size_t i = 0; i < arm.size(); ++i) {
    const ArmLink<Real>& link = arm.links[i];
    const std::string place = "link " + std::to_string(i + 1) + " of the arm";
    if (!(abs(link.axis.norm() - Real(1)) < Real(1) / Real(1000000)))
      throw Error(place, "an axis that is no unit vector", "length 1");
    if (!(link.mass >= Real(0) && link.far_mass >= Real(0)) || !is_finite(link.mass + link.far_mass))
      throw Error(place, "a mass that is negative or no number", "kg, zero or positive");
    if (link.far_mass != Real(0) && link.compliance.diagonal().isZero(Real(0)))
      throw Error(place, "a mass that moves with its far end, which does not yield", "all of it in its mass");
    if (!(link.joint_compliance >= Real(0)) || !is_finite(link.joint_compliance))
      throw Error(place, "a joint compliance that is negative or no number", "zero or positive");
    if (!(link.compliance.diagonal().minCoeff() >= Real(0)) ||
        !(link.compliance == link.compliance.transpose()))
      throw Error(place, "a compliance that is negative or not symmetric", "a symmetric matrix");
  }
}

}  // namespace plumbline
