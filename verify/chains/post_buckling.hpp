#pragma once
/// \file
/// How the force begins to change along a branch of bent shapes.

#include <plumbline/chain/mode.hpp>

namespace plumbline::verify {

/// F_2 of F = F_m + F_2 a^2 + … along the exact equilibria theta = a phi + …, phi the orientations of a mode
/// and the end point kept on the axis (theorem "Supercritical"): positive where bent shapes exist above the
/// critical force only.
template <Number Real>
Real post_buckling_curvature(const Chain<Real>& chain, const Mode<Real>& mode) {
  Real square(0), cubic(0), quartic(0);
  const std::vector<Real> phi = orientations(mode.q);
  for (std::size_t j = 0; j < phi.size(); ++j) {
    const Real second = chain.length()[j] * (phi[j] * phi[j]);
    square = square + second;
    cubic = cubic + second * phi[j];
    quartic = quartic + second * phi[j] * phi[j];
  }
  // the theorem's c is the lateral force on the chain, the mode's F_y that which the chain exerts
  return (mode.force * quartic / Real(6) - Real(2) * mode.fy * cubic / Real(3)) / square;
}

}  // namespace plumbline::verify
