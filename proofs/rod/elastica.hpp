#pragma once
/// \file
/// The bent rod (elastica): a cantilever of unit length and E I under a dead force at its tip, enclosed by
/// elliptic integrals.
///
/// With psi, the angle of the rod from where the force pushes against it, psi'' = -force sin psi: sin(psi /
/// 2) = k sin u, k that of the tip, turns the rod's length into F(pi / 2, k) - F(u_0, k), u_0 at the clamp
/// (S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 1961, 2.7; K. E. Bisshopp, D. C. Drucker,
/// Quart. Appl. Math. 3, 1945).

#include <plumbline/base/interval.hpp>

namespace plumbline::proofs {

struct BentCantilever {
  Interval force;  ///< in E I / length^2
  Interval tip;    ///< the angle by which the tip has turned
  Interval x, y;   ///< where the tip is: along the straight rod and across
};

/// Of a tip that has turned by an angle, certainly between 0 and pi - lean.
/// \param lean  of the force: 0 pushes against the straight rod, pi / 2 across it
BentCantilever bent_cantilever(const Interval& tip, const Interval& lean = 0);

/// Of a force across, certainly positive.
BentCantilever cantilever_pushed_across(const Interval& force);

}  // namespace plumbline::proofs
