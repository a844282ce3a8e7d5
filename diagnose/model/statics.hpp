#pragma once
/// \file
/// The equations of equilibrium of the chain on its rig, in absolute angles, and their tangent.
///
/// With T_j the force that link j passes on (the end force and the weights beyond), the mixed potential
///   Phi(theta, F) = U(theta) - sum_j L_j ((u_j . T_j) + c_a (u_j . T_j)^2 / 2) - F . C F / 2
/// is stationary in theta at equilibrium, and -dPhi/dF is the end point: axial, base and train compliance
/// enter by their complementary energy and add no unknown. Only neighbours couple, so the stiffness is a
/// band. A link that bends is one quadratic finite element of its tangent angle with three nodes (start,
/// middle, end): exact for end loads in the linear theory, and integrated with three Gauss points in the
/// nonlinear one.

#include <vector>

#include "diagnose/model/band_matrix.hpp"
#include "diagnose/model/joint_law.hpp"
#include "diagnose/model/rig.hpp"

namespace plumbline::diagnose {

/// The unknowns: node angles (one a link, or three where links bend), the state of the dry contacts, and
/// the force on the end point.
struct Posture {
  std::vector<double> angle;
  std::vector<Contact> contact;  ///< of each joint
  Vector2 force = Vector2::Zero();
};

/// The rig during one run: its joints know their rest angles.
struct RunRig {
  RunRig(const Rig& whole, const std::vector<double>& commanded_rest);
  Rig rig;
  std::vector<JointLaw> joint;
  double rest_orientation;      ///< theta_n of the unloaded shape
  std::vector<Vector2> beyond;  ///< weight that link j carries at its middle but for its own half
};

/// The time that ends with a reading: what history the joints follow in it.
struct TimeStep {
  bool relaxed = true;  ///< slowly, and before the first reading: no friction, no Maxwell arm
  double decay = 1, gain = 1;
};

/// What is imposed: the true end point or the true force.
struct Imposed {
  ControlMode control;
  Vector2 value;
};

/// Which unknowns there are and which of them couple.
struct Layout {
  std::size_t links;
  bool bending, coupled, dry;
  [[nodiscard]] std::size_t nodes_per_link() const { return bending ? 3 : 1; }
  [[nodiscard]] std::size_t nodes() const { return links * nodes_per_link(); }
  [[nodiscard]] std::size_t first(std::size_t link) const { return link * nodes_per_link(); }
  [[nodiscard]] std::size_t last(std::size_t link) const { return first(link) + nodes_per_link() - 1; }
  [[nodiscard]] std::size_t half_width() const { return bending ? (coupled ? 4 : 2) : (coupled ? 2 : 1); }
  /// q_i of a posture, i from 0.
  [[nodiscard]] double joint_angle(const Posture& posture, std::size_t i) const {
    return posture.angle[first(i)] - (i > 0 ? posture.angle[last(i - 1)] : 0.0);
  }
};

/// Residual torques, end point and their derivatives at one posture.
struct Equations {
  explicit Equations(const Layout& layout);

  /// Evaluates residual and end point; with `tangent` also the derivatives.
  void assemble(const RunRig& run, const Posture& posture, const std::vector<JointMemory>& memory,
                const TimeStep& interval, bool tangent);

  Layout layout;
  std::vector<double> residual;                ///< torque out of balance at each node
  Vector2 end_point;                           ///< of the last link's axis
  BandMatrix stiffness;                        ///< d residual / d angle
  std::vector<double> arm_x, arm_y;            ///< d end_point / d angle
  std::vector<double> by_force_x, by_force_y;  ///< d residual / d force
  Eigen::Matrix2d compliance;                  ///< d end_point / d force

 private:
  void add_joints(const RunRig& run, const Posture& posture, const std::vector<JointMemory>& memory,
                  const TimeStep& interval, bool tangent);
  void add_coupling(const RunRig& run, const Posture& posture, bool tangent);
  void add_rigid_link(const RunRig& run, std::size_t link, const Posture& posture, bool tangent);
  void add_bending_link(const RunRig& run, std::size_t link, const Posture& posture, bool tangent);
  void add_end(const RunRig& run, const Posture& posture, bool tangent);
  void add_stiffness(std::size_t row, std::size_t column, double value);
};

}  // namespace plumbline::diagnose
