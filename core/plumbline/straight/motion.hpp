#pragma once
/// \file
/// Small motion of a straight structure about its line, with masses at its nodes: what decides the stability
/// of loads that have no energy, such as a force that follows the last link.
///
/// M w'' + (K - factor A) w = 0 in the deflections w of the nodes, M diagonal. For dead forces A is the
/// pencil's G (pencil.hpp). A force p against the link j that it follows has the part -p t_j across, t_j the
/// link's slope, which a dead force has not: A = G - p e_j t_j^T, and is not symmetric. The squares of the
/// circular frequencies are the eigenvalues of M^-1 (K - factor A). The line is stable while they are real,
/// positive and distinct; where one passes zero it gives way without swinging (divergence), where two meet
/// and leave the real line it swings ever wider (flutter).

#include <plumbline/straight/pencil.hpp>

namespace plumbline {

/// M w'' + (K - factor A) w = 0.
template <Number Real>
struct StraightMotion {
  Matrix<Real> stiffness;             ///< K, symmetric
  Matrix<Real> load;                  ///< A
  std::vector<Real> mass;             ///< the diagonal of M
  std::vector<Eigen::Index> unknown;  ///< of each node, -1 for one that is held
};

/// \throws Error as straight_pencil() but for follower loads, and where a node that can move has no mass
template <Ordered Real>
StraightMotion<Real> straight_motion(const Structure<Real>& structure) {
  Structure<Real> dead = structure;
  for (Load<Real>& load : dead.loads) load.kind = LoadKind::dead;
  const StraightPencil<Real> pencil = straight_pencil(dead);
  const Eigen::Index n = pencil.size();
  const auto full = [n](const Band<Real, 2>& band) {
    Matrix<Real> matrix = Matrix<Real>::Constant(n, n, Real(0));
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index d = 0; d <= 2 && i + d < n; ++d) matrix(i + d, i) = matrix(i, i + d) = band(d, i);
    }
    return matrix;
  };
  StraightMotion<Real> motion{full(pencil.stiffness), full(pencil.load),
                              std::vector<Real>(static_cast<std::size_t>(n), Real(0)), pencil.unknown};
  const std::vector<Real> mass = structure.masses();
  for (std::size_t node = 0; node < mass.size(); ++node) {
    const Eigen::Index i = pencil.unknown[node];
    if (i >= 0) motion.mass[static_cast<std::size_t>(i)] += mass[node];
  }
  if (!std::all_of(motion.mass.begin(), motion.mass.end(), [](const Real& m) { return m > Real(0); }))
    throw Error("masses", "a place without a mass that can move",
                "a positive mass at each joint and the end point, and at a base that moves");
  for (const Load<Real>& load : structure.loads) {
    const Eigen::Index at = pencil.unknown[load.node], before = pencil.unknown[load.node - 1];
    if (load.kind != LoadKind::follower || at < 0) continue;
    const Real slope = -load.force.x / structure.chain.length()[load.node - 1];
    Matrix<Real>& matrix = load.multiplied ? motion.load : motion.stiffness;
    const Real sign = load.multiplied ? Real(-1) : Real(1);
    matrix(at, at) += sign * slope;
    if (before >= 0) matrix(at, before) -= sign * slope;
  }
  return motion;
}

}  // namespace plumbline
