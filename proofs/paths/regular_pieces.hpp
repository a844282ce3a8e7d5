#pragma once
/// \file
/// The parts of a branch on which its equilibria are regular.

#include <plumbline/branch/trace.hpp>
#include <plumbline/loaded/nominal_model.hpp>

#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

/// What is left out between two pieces, or at an end: a bifurcation and what is around it.
struct Crossing {
  BranchPoint<double> point;
  Span loads;
};

struct RegularPieces {
  std::vector<std::vector<BranchPoint<double>>> points;  ///< of each piece, one more than crossings
  std::vector<Crossing> crossings;                       ///< in their order
};

/// Cuts a branch where another one crosses; each piece ends at a distance `gap` from there, in radians (root
/// mean square turn of the links). A stretch that ends in a fold is continued beyond it: that shows the fold.
RegularPieces regular_pieces(Brancher<NominalModel<double>>& brancher, const Branch<double>& branch,
                             double gap);

/// From a to b.
Variation<double> chord(const BranchPoint<double>& a, const BranchPoint<double>& b);

/// Points nearer to each other than this are one, in radians.
inline constexpr double same_point = 1e-9;

}  // namespace plumbline::proofs
