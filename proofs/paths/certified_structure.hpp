#pragma once
/// \file
/// Whether a path of a planar structure that was followed in double precision is there: proved as
/// certified_path.hpp does it, from the equations of structure_equations.hpp.
///
/// Tubes join from point to point, so that the equilibria are one analytic curve that no other branch
/// crosses. The energy's Hessian on the motions that are permitted is singular exactly where the factor
/// turns, and one point between two turns proves how many negative directions it has. A bifurcation, and what
/// is within `gap` of it, is left out.

#include <plumbline/space/bent_branch.hpp>
#include <plumbline/structure/structure.hpp>

#include "proofs/paths/certified_path.hpp"

namespace plumbline::proofs {

struct StructureCertificate {
  std::vector<CertifiedRun> runs;  ///< over which the factor only grows, or only falls, in their order
  std::vector<Span> folds;         ///< factors: in each the factor turns exactly once
  std::vector<Span> gaps;          ///< factors around bifurcations, which are not covered
  std::optional<Span> failed_at;   ///< factors where the first tube, or its type, is not proved
  std::string failure;             ///< why not
  std::size_t segments = 0;        ///< tubes
  double tube = 0;                 ///< so far from the chord an unknown may be, in radians at a link
  double distance = 0;             ///< so near are the points to the curve

  /// Whether everything is proved but what lies in the gaps.
  [[nodiscard]] bool certified() const { return !failed_at; }
};

/// Proves what it can of a branch of bent_structure(structure). O(n^3) a segment.
/// \param last  the factor to which it was followed: what a step of the factor counts for is its share of it
/// \param gap   distance from a bifurcation on either side, in radians, that is left out
/// \throws Error for a follower load
StructureCertificate certify(const Structure<Rational>& structure, const BentBranch<double>& branch,
                             double last, double gap = 1e-4);

}  // namespace plumbline::proofs
