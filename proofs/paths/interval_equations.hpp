#pragma once
/// \file
/// The equations of a branch in intervals of 64 digits, with their first two derivatives.

#include <plumbline/chain/chain.hpp>
#include <plumbline/loaded/loading.hpp>

#include "proofs/exact/interval_matrix.hpp"

namespace plumbline::proofs {

/// What the equations E are at u.
struct LocalEquations {
  IntervalVector value;               ///< E
  Matrix<Interval> derivative, bend;  ///< of E by all unknowns; psi · E''
};

/// Equations and unknowns as in BranchEquations: theta, where the end point is held the force on it, the
/// load.
class IntervalEquations {
 public:
  /// Both have to outlive it.
  IntervalEquations(const Chain<Interval>& chain, const Loading<Interval>& loading)
      : chain_(&chain),
        loading_(&loading),
        n_(static_cast<Eigen::Index>(chain.size())),
        held_(loading.control == Control::end_point) {}

  /// How many equations: one less than unknowns.
  [[nodiscard]] Eigen::Index size() const { return n_ + (held_ ? 2 : 0); }

  /// At any u and psi in these boxes.
  [[nodiscard]] LocalEquations at(const IntervalVector& u, const IntervalVector& psi) const;

 private:
  void springs(const IntervalVector& u, LocalEquations& all) const;
  void link(Eigen::Index i, const Point<Interval>& force, const Interval& theta, const IntervalVector& psi,
            LocalEquations& all) const;

  const Chain<Interval>* chain_;
  const Loading<Interval>* loading_;
  Eigen::Index n_;
  bool held_;
};

}  // namespace plumbline::proofs
