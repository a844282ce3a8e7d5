#pragma once
/// \file
/// The rig as a loaded model in absolute angles.
///
/// With T_j the force that link j transmits (the end force, and the weights and forces beyond) and M_j the
/// moment of tendons and pressures, the mixed potential
///   Phi(theta, F) = U(theta) - sum_j (L_j ((u_j . T_j) + c_a (u_j . T_j)^2 / 2) + M_j q_j) - F . C F / 2
/// is stationary in theta at equilibrium, and -dPhi/dF is the end point: axial, base and train compliance
/// enter by their complementary energy and add no unknown. The stored energy is Phi + F . p, where dry
/// contacts and Maxwell arms contribute their work since the last reading. An eccentric load has no
/// potential. Only neighbours couple, so the stiffness matrix is banded. A bending link is one quadratic
/// finite element of its tangent angle with three nodes (start, middle, end): exact for end loads in the
/// linear theory, and integrated with three Gauss points in the nonlinear one.

#include <plumbline/loaded/loaded_model.hpp>

#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {

/// \tparam Bandwidth  that of the layout: 1, or 2 with coupling or bending, or 4 with both
template <int Bandwidth>
class RigModel {
 public:
  using Real = double;
  static constexpr int bandwidth = Bandwidth;
  using At = Expansion<double, Bandwidth>;

  explicit RigModel(const Layout& layout) : layout_(layout) {}

  /// Sets the rig, the step, the loads along the chain and the state of the contacts, all by reference.
  void become(const RigStep& step, const ChainLoads& loads, const std::vector<Contact>& contact) {
    step_ = &step;
    loads_ = &loads;
    contact_ = &contact;
  }

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] std::size_t size() const { return layout_.nodes(); }
  /// The end point is that of the drive, beyond the compliance of the load train.
  void expand(const Vector<double>& angle, const Point<double>& force, At& at) const;
  /// Residual and end point alone.
  void balance(const Vector<double>& angle, const Point<double>& force, At& at) const;

 private:
  template <bool derivatives>
  void assemble(const Vector<double>& angle, const Point<double>& force, At& at) const;
  /// Torque of a joint's sliders and Maxwell arms.
  [[nodiscard]] Torque history(std::size_t joint, double q) const;
  template <bool derivatives>
  void add_joints(const Vector<double>& angle, At& at) const;
  /// Adds the torque of a joint: to the node behind it and, with opposite sign, to the node before it.
  template <bool derivatives>
  void add_torque(std::size_t joint, double value, double slope, At& at) const;
  /// Adds the torques of user effects. They may depend on the force, so the equations lose their symmetry;
  /// the stored energy does not contain them.
  template <bool derivatives>
  void add_stated(std::size_t joint, double q, const Vector2& force, At& at) const;
  template <bool derivatives>
  void add_coupling(const Vector<double>& angle, At& at) const;
  /// Loads a joint alone: its end point is its angle, its force its torque.
  template <bool derivatives>
  void load_joint(const Vector<double>& angle, const Vector2& force, At& at) const;
  template <bool derivatives>
  void add_rigid_links(const Vector<double>& angle, const Vector2& force, At& at) const;
  template <bool derivatives>
  void add_bending_link(std::size_t link, const Vector<double>& angle, const Vector2& force, At& at) const;
  /// The moment of a share of a link's weight, by as much as its centre lies beside the link.
  template <bool derivatives>
  void add_beside(std::size_t link, double share, Eigen::Index node, const Vector2& u, At& at) const;
  template <bool derivatives>
  void add_end(const Vector<double>& angle, const Vector2& force, At& at) const;

  Layout layout_;
  const RigStep* step_ = nullptr;
  const ChainLoads* loads_ = nullptr;
  const std::vector<Contact>* contact_ = nullptr;
  /// Unit vectors along rigid links at the last shape: varied rigs are evaluated at the same one.
  mutable std::vector<Vector2> along_;
  mutable Vector<double> along_at_;
};

extern template class RigModel<1>;
extern template class RigModel<2>;
extern template class RigModel<4>;

}  // namespace plumbline::diagnose
