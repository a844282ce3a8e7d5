#pragma once
/// \file
/// The rig in one run, and where it stands: its unknowns, its history, what is imposed.

#include <plumbline/base/number.hpp>
#include <plumbline/chain/kinematics.hpp>
#include <plumbline/loaded/control.hpp>
#include <vector>

#include "diagnose/rig/joint_law.hpp"
#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The unknowns: node angles (one a link, or three where links bend), the state of the dry contacts, and
/// the force on the end point.
struct Posture {
  Vector<double> angle;
  std::vector<Contact> contact;  ///< of each joint's sliders, see Layout
  Point<double> force{0, 0};
};

/// The time constants of the Maxwell arms that joints have, s: of those beside every spring, then of those
/// that free laws have besides.
std::vector<double> arm_times(const Rig& rig);
/// How many springs that slip a joint has, but for its dry friction. \param joint  from 0
std::size_t slider_count(const Rig& rig, std::size_t joint);

/// The rig during one run: its joints know their rest angles.
struct RunRig {
  /// \param own  the rig as it stands in this run
  RunRig(Rig own, const std::vector<double>& commanded_rest);
  Rig rig;
  std::vector<double> arm_time;  ///< see arm_times()
  std::vector<JointLaw> joint;
  double rest_orientation;      ///< theta_n of the unloaded shape
  double largest_stiffness;     ///< of all joints
  std::vector<Vector2> beyond;  ///< weight that link j carries at its middle but for its own half
};

/// The time that ends with a reading: what history the joints follow in it.
struct TimeStep {
  TimeStep() { decay.fill(1), gain.fill(1); }
  bool relaxed = true;  ///< slowly, and before the first reading: no Maxwell arm, few sliders
  double end = 0;       ///< time of the reading, s
  std::array<double, most_arms> decay, gain;  ///< of the rig's arms
};

/// A rig on its way to a reading, and what its joints remember of the one before.
struct RigStep {
  const RunRig& run;
  TimeStep interval;
  const std::vector<JointMemory>& memory;
};

/// What is imposed: the true end point or the true force.
struct Imposed {
  Control control;
  Vector2 value;
};

/// Which unknowns there are and which of them couple.
struct Layout {
  std::size_t links;
  bool bending, coupled;
  std::size_t sliders;  ///< of each joint
  [[nodiscard]] std::size_t nodes_per_link() const { return bending ? 3 : 1; }
  [[nodiscard]] std::size_t nodes() const { return links * nodes_per_link(); }
  /// Where the state of a joint's slider stands.
  [[nodiscard]] std::size_t contact(std::size_t joint, std::size_t slider) const {
    return joint * sliders + slider;
  }
  [[nodiscard]] std::size_t first(std::size_t link) const { return link * nodes_per_link(); }
  [[nodiscard]] std::size_t last(std::size_t link) const { return first(link) + nodes_per_link() - 1; }
  /// Of the stiffness: 1, 2 or 4.
  [[nodiscard]] int bandwidth() const { return (bending ? 2 : 1) * (coupled ? 2 : 1); }
  /// q_i of a shape, i from 0.
  [[nodiscard]] double joint_angle(const Vector<double>& angle, std::size_t i) const {
    const double before = i > 0 ? angle(static_cast<Eigen::Index>(last(i - 1))) : 0.0;
    return angle(static_cast<Eigen::Index>(first(i))) - before;
  }
};

}  // namespace plumbline::diagnose
