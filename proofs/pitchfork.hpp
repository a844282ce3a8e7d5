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

#include <plumbline/branch/branch.hpp>

#include "proofs/span.hpp"
#include "proofs/symmetry.hpp"

namespace plumbline::proofs {

/// A point near the branch, and how near, entry by entry of theta, the force and the load.
struct Near {
  BranchPoint<double> point;
  double distance;
};

/// The loads at which the symmetric branch through `before` bifurcates, once, into the branch through
/// `after`; nothing where that is not proved. \param crossing  close to the bifurcation
std::optional<Span> pitchfork(const Chain<Interval>& chain, const Loading<Interval>& loading,
                              const Symmetry& symmetry, const Near& before,
                              const BranchPoint<double>& crossing, const Near& after);

}  // namespace plumbline::proofs
