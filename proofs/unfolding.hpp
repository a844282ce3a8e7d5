#pragma once
/// \file
/// That nothing bifurcates where two branches of a chain without symmetry pass each other closely.
///
/// With the load among the unknowns u, equilibria E(u) = 0 branch only where a vector psi, other than zero,
/// has psi^T E'(u) = 0. Let x be the unknowns but the load, and b a vector. The system of Moore,
///
///     E(u) + tau b = 0,    psi^T dE/dx = 0,    psi^T dE/dload = 0,    b · psi = 1
///
/// is regular at a bifurcation where two branches cross, and near it: it says by how much tau a term tau b
/// makes two passing branches cross. Krawczyk's operator proves one root in a box; where tau is not zero, no
/// equilibrium in there is a bifurcation. The chain's own asymmetry may be as small as 64 digits
/// resolve.

#include <plumbline/loaded/loading.hpp>

namespace plumbline::proofs {

/// Whether it is proved that no equilibrium is a bifurcation, as far as `distance` from a point in every
/// entry (theta, where the end point is held the force on it, the load), all without units (ProvedPiece).
bool unfolded(const Chain<Interval>& chain, const Loading<Interval>& loading, const Vector<double>& crossing,
              double distance);

}  // namespace plumbline::proofs
