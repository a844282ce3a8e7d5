#pragma once
/// \file
/// Bifurcations of symmetric chains, proved by the method of Lyapunov and Schmidt in intervals.
///
/// With a symmetry S, write u = m + a v: the mean m is symmetric (S m = m), the bend v antisymmetric (S v =
/// -v), scaled by l · v = 1, and a is the amplitude. Then E(m + a v) has a symmetric part and an
/// antisymmetric one, and
///
///     symmetric part = 0,    antisymmetric part / a = 0,    l · v = 1
///
/// is a regular system for m, the load and v, even in a, also at a = 0 where the bent branch leaves the
/// symmetric one. Krawczyk's operator over a box, for all amplitudes from 0 to that of a point on the bent
/// branch, proves one smooth curve from the one to the other; the symmetric branch up to there is proved
/// among symmetric shapes, where it is regular.

#include <plumbline/loaded/loading.hpp>
#include <vector>

#include "proofs/exact/span.hpp"
#include "proofs/paths/symmetry.hpp"

namespace plumbline::proofs {

/// The end of a proved piece of a branch, without units (ProvedPiece): an equilibrium of the piece is within
/// `distance` of `point`, entry by entry.
struct PieceEnd {
  Vector<double> point;
  double distance;
};

/// A crossing, and which ends are joined to it: by symmetric equilibria, or by the bent branch.
struct Fork {
  Span load;  ///< without units
  std::vector<std::size_t> symmetric, bent;
};

/// Where a symmetric branch is crossed by a bent one, and which of the ends are proved to lie on them;
/// nothing where no crossing is proved.
/// \param crossing  close to it, without units
std::optional<Fork> pitchfork(const Chain<Interval>& chain, const Loading<Interval>& loading,
                              const Symmetry& symmetry, const Vector<double>& crossing,
                              const std::vector<PieceEnd>& ends);

}  // namespace plumbline::proofs
