#pragma once
/// \file
/// The straight chain in space under compression as a symmetric pencil, of 2 (n - 1) critical forces where
/// every joint bends about two axes and the end point is guided.
///
/// To second order in the joint angles q the link j leans by t_j = sum of q a x e over the axes a up to it, e
/// along the chain, and shortens the chain by L_j t_j^2 / 2, in whatever order a joint's axes are turned
/// about. So K = diag(k) + sum s_i w_i^T w_i - sum N_j L_j t_j^T t_j with the springs s_i against deflections
/// w_i and the compression N_j of fixed loads, and G = sum N_j L_j t_j^T t_j with that of multiplied ones, on
/// the q that what holds the chain permits; twist, a along e, does not enter. An axis of length |a| stands
/// for the spring k |a|^2, so that any decimals are directions.

#include <plumbline/space/space_structure.hpp>

namespace plumbline {

/// K - factor G, dense, in the unknowns y, where the axes that bend turn by basis y.
template <Number Real>
struct SpacePencil {
  Matrix<Real> stiffness;         ///< K: springs and fixed loads
  Matrix<Real> load;              ///< G: loads that the factor multiplies
  Matrix<Real> basis;             ///< a row for each axis that is not along the chain
  std::vector<std::size_t> axis;  ///< the axis of each row, counted over all joints
  /// The matrix at a factor.
  [[nodiscard]] Matrix<Real> at(const Real& factor) const { return stiffness - factor * load; }
};

namespace detail {

/// A basis of what the rows of C map to zero, by elimination: exact where the numbers are.
template <Ordered Real>
Matrix<Real> null_space(Matrix<Real> C) {
  const Eigen::Index columns = C.cols();
  std::vector<Eigen::Index> pivots;
  for (Eigen::Index column = 0, row = 0; column < columns && row < C.rows(); ++column) {
    Eigen::Index best = row;
    while (best < C.rows() && C(best, column) == Real(0)) ++best;
    if (best == C.rows()) continue;
    C.row(best).swap(C.row(row));
    const Real pivot = C(row, column);
    for (Eigen::Index j = 0; j < columns; ++j) C(row, j) /= pivot;
    for (Eigen::Index i = 0; i < C.rows(); ++i) {
      const Real share = C(i, column);
      if (i == row || share == Real(0)) continue;
      for (Eigen::Index j = 0; j < columns; ++j) C(i, j) -= share * C(row, j);
    }
    pivots.push_back(column);
    ++row;
  }
  const auto rank = static_cast<Eigen::Index>(pivots.size());
  Matrix<Real> basis = Matrix<Real>::Constant(columns, columns - rank, Real(0));
  for (Eigen::Index column = 0, next = 0; column < columns; ++column) {
    if (std::find(pivots.begin(), pivots.end(), column) != pivots.end()) continue;
    basis(column, next) = Real(1);
    for (Eigen::Index row = 0; row < rank; ++row)
      basis(pivots[static_cast<std::size_t>(row)], next) = -C(row, column);
    ++next;
  }
  return basis;
}

}  // namespace detail

/// The pencil of a straight chain under its forces. \throws Error as compression() does, and where nothing
/// bends
template <Ordered Real>
SpacePencil<Real> space_pencil(const SpaceStructure<Real>& structure) {
  structure.require_sound();
  const SpaceChain<Real>& chain = structure.chain;
  const auto [of_fixed, of_multiplied] = compression(structure);
  SpacePencil<Real> pencil;
  std::vector<Real> springs;
  std::vector<std::array<Real, 2>> lean;  // of what lies beyond, by a turn about each axis
  std::vector<std::size_t> joint;
  std::size_t number = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    for (const Axis<Real>& axis : chain.joint[i].axes) {
      const auto& a = axis.direction;
      const bool bends = a[1] != Real(0) || a[2] != Real(0);
      if (bends && !(i == 0 && structure.base == SpaceBase::clamped)) {
        springs.push_back(axis.stiffness * (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]));
        lean.push_back({a[2], Real(-a[1])});
        joint.push_back(i);
        pencil.axis.push_back(number);
      }
      ++number;
    }
  }
  const auto m = static_cast<Eigen::Index>(springs.size());
  if (m == 0) throw Error("joints", "no axis that bends the chain", "one that is not along it");
  const auto slopes = [&](std::size_t link) {  // rows t_y and t_z
    Matrix<Real> t = Matrix<Real>::Constant(2, m, Real(0));
    for (Eigen::Index a = 0; a < m; ++a) {
      const auto at = static_cast<std::size_t>(a);
      if (joint[at] <= link) t(0, a) = lean[at][0], t(1, a) = lean[at][1];
    }
    return t;
  };
  Matrix<Real> K = Matrix<Real>::Constant(m, m, Real(0)), G = K, w = Matrix<Real>::Constant(2, m, Real(0));
  Matrix<Real> held = Matrix<Real>::Constant(2 * static_cast<Eigen::Index>(chain.size() + 1), m, Real(0));
  Eigen::Index rows = 0;
  const auto hold = [&](const Matrix<Real>& what) {
    held.middleRows(rows, 2) = what;
    rows += 2;
  };
  const auto add_push = [&](Matrix<Real>& to, const std::vector<Real>& N, std::size_t i,
                            const Matrix<Real>& t) { to += N[i] * chain.length[i] * (t.transpose() * t); };
  for (Eigen::Index a = 0; a < m; ++a) K(a, a) = springs[static_cast<std::size_t>(a)];
  Matrix<Real> fixed = G;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Matrix<Real> t = slopes(i);
    add_push(G, of_multiplied, i, t);
    add_push(fixed, of_fixed, i, t);
    w += chain.length[i] * t;
    const Restraint<Real> across = structure.across_at(i + 1);
    if (across.hold == Hold::sprung) K += across.stiffness * (w.transpose() * w);
    if (across.is_held()) hold(w);
  }
  K -= fixed;
  if (structure.end_point.turn.is_held()) hold(slopes(chain.size() - 1));
  pencil.basis = detail::null_space<Real>(held);
  const Matrix<Real>& N = pencil.basis;
  pencil.stiffness = N.transpose() * K * N;
  pencil.load = N.transpose() * G * N;
  return pencil;
}

}  // namespace plumbline
