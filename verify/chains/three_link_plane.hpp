#pragma once
/// \file
/// All equilibria of three links over a whole range of deflections at once.
///
/// On a passive base the end point can be turned onto the x axis, so that a shape is a point (a, b) of the
/// plane of the two elastic joints' angles, its distance r from the base to the end point a function of (a,
/// b), and the energy E = k_2 (a - alpha_1)^2/2 + k_3 (b - alpha_2)^2/2. With the end point held, equilibria
/// are where the gradients of E and of r^2 are parallel: on the curve g = E_a r^2_b - E_b r^2_a = 0, the same
/// for all deflections. Where the determinant of the derivatives of (g, r^2) is not zero, the curve crosses
/// the lines of equal r; the Hessian of E along such a line is then regular. If that holds of the whole curve
/// between two distances, and it does not leave the window between them, then as many equilibria belong to
/// each distance, and each keeps its type; and its shape, if no joint is straight on the curve.

#include <string>
#include <vector>

#include "verify/chains/loaded_chains.hpp"

namespace plumbline::verify {

/// A piece of the plane that may hold equilibria, all of one shape.
struct PlanePiece {
  std::string signs;     ///< of both joint angles, such as "+-"
  Interval distance;     ///< of the end point from the base, squared
  Interval energy;       ///< stored
  Interval compression;  ///< force that pushes the end point towards the base
};

struct PlaneProof {
  Interval from, to;               ///< deflections, from the chain without load
  bool whole = true;               ///< every equilibrium can be followed through the range, as said above
  std::vector<PlanePiece> pieces;  ///< no equilibrium is elsewhere
  std::size_t boxes = 0;           ///< looked at

  /// "every deflection from 0 to 1.135 L, 2260 boxes of the plane of both joint angles: …"
  [[nodiscard]] std::string text() const;
  /// Whether the equilibria of one shape have less of something than all others, at every deflection.
  [[nodiscard]] bool least(const std::string& signs, Interval PlanePiece::*what) const;
};

/// For three links with a passive base, joint angles within half a turn. Computed once.
/// \param from, to  deflections
const PlaneProof& prove_in_plane(const HeldChain& chain, const Rational& from, const Rational& to);

}  // namespace plumbline::verify
