#pragma once
/// \file
/// The bent rod (elastica): a cantilever under an axial dead force, enclosed by complete elliptic integrals.

#include <plumbline/base/interval.hpp>

namespace plumbline::proofs {

/// Of a cantilever of unit length and E I, whose tip has turned by an angle.
struct BentCantilever {
  Interval force;  ///< against the straight rod's axis, in E I / length^2
  Interval x, y;   ///< where the tip is
};

/// With k = sin(angle / 2): force = K(k)^2, x = 2 E(k) / K(k) - 1, y = 2 k / K(k); K and E by the
/// arithmetic-geometric mean. S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 1961, 2.7.
/// \param tip  angle in radians, certainly between 0 and pi
BentCantilever bent_cantilever(const Interval& tip);

}  // namespace plumbline::proofs
