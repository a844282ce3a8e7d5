#pragma once
/// \file
/// A straight chain in space under a torque at its end point, about the line.
///
/// The torque T does the work T a_k . x dq_k as the axis a_k turns, and a_k . x is, to first order, what the
/// axes before it have turned it out of the plane across: sum over l < k of q_l x . (a_l x a_k). So K q = T S
/// q with S_kl = x . (a_l x a_k) for l < k and zero elsewhere, where the torque keeps its direction along the
/// line (axial). Where it turns with the last link (tangential) the matrix is S^T, and of the mean of both
/// (semitangential) (S + S^T) / 2. The last alone is symmetric: it alone has an energy, unless the direction
/// of the last link is held, where q^T (S - S^T) q' = x . (sum q_l a_l x sum q'_k a_k) is zero and all three
/// are the same. A base that is a bearing takes the torque off the first link in the same way as it acts on
/// the last one: what the axes of joint 1 do to each other drops out of S. So the chain stands for a shaft
/// between two bearings.

#include <plumbline/space/space_pencil.hpp>

namespace plumbline {

/// K - T S in the unknowns of a pencil without compression.
template <Number Real>
struct TorquePencil {
  Matrix<Real> stiffness;  ///< K
  Matrix<Real> torque;     ///< S; symmetric where the torque is conservative
  bool conservative;       ///< whether the torque has a potential
};

/// \throws Error for an axis along the chain, or oblique, which a torque twists at once
template <Ordered Real>
TorquePencil<Real> torque_pencil(const SpaceStructure<Real>& structure) {
  if (!structure.torque) throw Error("loads", "no torque", "one at the end point");
  const SpaceChain<Real>& chain = structure.chain;
  const SpacePencil<Real> pencil = space_pencil(structure);
  std::vector<std::array<Real, 3>> axes;
  for (const SpaceJoint<Real>& joint : chain.joint) {
    for (const Axis<Real>& axis : joint.axes) {
      if (axis.direction[0] != Real(0))
        throw Error("joints", "an axis that is not across the chain",
                    "axes across it: a torque twists others at once");
      axes.push_back(axis.direction);
    }
  }
  const Eigen::Index m = pencil.basis.rows();
  Matrix<Real> S = Matrix<Real>::Constant(m, m, Real(0));
  for (Eigen::Index k = 0; k < m; ++k) {
    for (Eigen::Index l = 0; l < k; ++l) {
      if (structure.base == SpaceBase::bearing &&
          pencil.axis[static_cast<std::size_t>(k)] < chain.joint[0].axes.size())
        continue;
      const auto &a = axes[pencil.axis[static_cast<std::size_t>(l)]],
                 &b = axes[pencil.axis[static_cast<std::size_t>(k)]];
      S(k, l) = a[1] * b[2] - a[2] * b[1];
    }
  }
  const Matrix<Real> transposed = S.transpose();
  if (*structure.torque == TorqueKind::tangential) S = transposed;
  if (*structure.torque == TorqueKind::semitangential) S = (S + transposed) / Real(2);
  const Matrix<Real> torque = pencil.basis.transpose() * S * pencil.basis;
  return {pencil.stiffness, torque, torque == Matrix<Real>(torque.transpose())};
}

}  // namespace plumbline
