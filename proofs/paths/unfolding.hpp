#pragma once
/// \file
/// That nothing bifurcates where two branches of a chain without symmetry pass each other closely.
///
/// Moore's system (moore_system.hpp) says by how much tau a term would make two passing branches cross. A
/// bifurcation is a root of it without such a term, and Krawczyk's operator keeps every root of a box: where
/// no tau that is left is zero, no equilibrium in the box is a bifurcation. The chain's own asymmetry may be
/// as small as 64 digits resolve.

#include <plumbline/loaded/loading.hpp>

namespace plumbline::proofs {

/// Whether it is proved that no equilibrium is a bifurcation, as far as `distance` from a point in every
/// entry (theta, where the end point is held the force on it, the load), all without units (ProvedPiece).
bool unfolded(const Chain<Interval>& chain, const Loading<Interval>& loading, const Vector<double>& crossing,
              double distance);

}  // namespace plumbline::proofs
