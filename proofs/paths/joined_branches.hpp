#pragma once
/// \file
/// All branches of a path, proved, and where they cross.

#include "proofs/paths/certified_path.hpp"
#include "proofs/paths/followed_path.hpp"
#include "proofs/paths/symmetry.hpp"

namespace plumbline::proofs {

/// The first or the last point of a proved piece.
struct EndOfPiece {
  std::size_t branch, piece;
  bool last;
};

/// A proved crossing of a symmetric branch and a bent one, and the ends that are joined by them.
struct ProvedFork {
  Span load;
  Symmetry symmetry;
  std::vector<EndOfPiece> symmetric, bent;
};

struct JoinedBranches {
  std::vector<PathCertificate> branches;  ///< with those gaps that stay open
  std::vector<ProvedFork> forks;          ///< through these the others are closed
};

/// Proves every branch, and closes gaps where a pitchfork of a symmetric chain joins what is on their sides.
JoinedBranches certify(const PathReport& report, const Chain<Interval>& chain,
                       const Loading<Interval>& loading, const std::vector<Symmetry>& symmetries,
                       ProvedPoints points = ProvedPoints::as_followed);

}  // namespace plumbline::proofs
