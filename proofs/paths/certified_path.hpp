#pragma once
/// \file
/// Whether a path of equilibria that was followed in double precision is there: proved by interval
/// arithmetic.
///
/// Between consecutive points, halved where need be, a tube (regular_tube.hpp) is proved to hold one smooth
/// curve of equilibria, and at every point a small box is proved to lie in both tubes that meet there and to
/// hold one piece of curve across both their planes. So all of them together are one analytic curve, without
/// gap or jump, and no other branch crosses it.
///
/// Along it the energy's Hessian, in the sense of the control, is singular exactly where the load turns: the
/// bordered matrix of the tube is regular, and by Cramer's rule the load's share of the tangent is the
/// Hessian's determinant but for a factor without a zero. So the number of negative directions is constant
/// between turns, and one point of each run proves it. Where the load's share of the tangent may vanish, the
/// second derivative has one sign, and with the signs on both sides it decides between no turn and exactly
/// one (a fold).

#include <plumbline/branch/trace.hpp>
#include <string>

#include "proofs/exact/span.hpp"

namespace plumbline::proofs {

/// Part of the curve over which the load only grows, or only falls, from the one to the other.
struct CertifiedRun {
  double from, to;
  std::size_t negative_directions;
};

/// A regular piece: between neighbours among its points a tube is proved. Without units: links in radians,
/// forces as shares of max k / max L, deflections of max L.
struct ProvedPiece {
  std::vector<Vector<double>> points;  ///< theta, where the end point is held the force on it, the load
  std::vector<Vector<double>> tubes;   ///< so near is the curve to the chord between neighbours
  std::vector<CertifiedRun> runs;
  std::vector<Span> folds;
  double distance = 0;  ///< so near are the points to the curve
};

/// Around a bifurcation, where equilibria are not regular.
struct Gap {
  Span loads;
  Vector<double> crossing;  ///< the bifurcation, without units, in double precision
  /// The pieces on its sides, if any are proved.
  std::optional<std::size_t> before, after;
  bool unfolded = false;  ///< it is proved that nothing bifurcates between them
};

struct PathCertificate {
  std::vector<ProvedPiece> pieces;
  std::vector<CertifiedRun> runs;  ///< in the order of the path
  std::vector<Span> folds;         ///< loads: in each the load turns exactly once
  std::vector<Gap> gaps;           ///< what is not covered
  std::optional<Span> failed_at;   ///< loads where the first tube, or its type, is not proved
  std::string failure;             ///< why not
  bool finite = true;              ///< the tangent stiffness along the load is finite all along
  bool stiff = true;               ///< it is finite and positive all along
  bool softens = true;             ///< it is finite and falls all along the path
  std::vector<Span> softest;       ///< loads: in each it has exactly one local minimum along the path
  bool counted = true;             ///< these are all its minima, but for the gaps
  std::size_t segments = 0;        ///< tubes
  double tube = 0;                 ///< widest, in radians: so far from the chord a link may point
  double distance = 0;             ///< in radians: so near are the points to the curve

  /// Whether everything is proved but what lies in the gaps.
  [[nodiscard]] bool certified() const { return !failed_at; }
  /// Certified without a gap, stable, and the load grows all along.
  [[nodiscard]] bool regular() const;
};

/// Which points the proof is about.
enum class ProvedPoints {
  as_followed,
  /// Rounded to nine decimals of a radian or share, far above what compilers and machines do otherwise: for
  /// certificates, which are to be the same wherever they are made. (Steps that begin at a bifurcation, whose
  /// lengths hang on nearly singular matrices, may still be others.)
  rounded
};

/// Proves what it can of a branch. O(n^3) a segment.
/// \param chain, loading  what the branch was followed with, enclosed
/// \param gap  distance from a bifurcation on either side, in radians (root mean square turn of the links),
///             that is left out
PathCertificate certify(const Chain<Interval>& chain, const Loading<Interval>& loading,
                        const Branch<double>& branch, ProvedPoints points = ProvedPoints::as_followed,
                        double gap = 1e-5);

}  // namespace plumbline::proofs
