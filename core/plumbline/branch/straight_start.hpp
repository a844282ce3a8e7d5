#pragma once
/// \file
/// Where the branches of a straight chain begin: its end point can only be pushed inwards, and every buckling
/// mode, to either side, is the beginning of a branch.

#include <plumbline/branch/branch.hpp>
#include <plumbline/loaded/nominal_model.hpp>
#include <plumbline/straight/buckling_mode.hpp>

namespace plumbline {

/// Whether every joint but the base is unbent at rest, and the base too.
template <Ordered Real>
bool is_straight(const Chain<Real>& chain) {
  return std::all_of(chain.rest().begin(), chain.rest().end(),
                     [](const Real& angle) { return angle == Real(0); });
}

/// The equilibria of a straight chain shortened a little along its axis: mode 1 with q scaled by +mu and -mu,
/// then mode 2 …, Newton's method beginning at the linearised shapes (35). The loading must push along -x.
template <Floating Real>
std::vector<BranchPoint<Real>> straight_starts(Brancher<NominalModel<Real>>& brancher,
                                               const Real& shortening) {
  using std::sqrt;
  const Chain<Real>& chain = brancher.model().chain();
  std::vector<BranchPoint<Real>> starts;
  for (const Mode<Real>& mode : critical_modes(chain, chain.size() - 1)) {
    const Real mu = sqrt(shortening / small_deflection(chain, mode.q).x);
    for (const Real& scale : {mu, Real(-mu)}) {
      const Vector<Real> theta = absolute_angles(mode.q) * scale;
      starts.push_back(brancher.start(shortening, theta, {Real(-mode.force), Real(-mode.fy * scale)}));
    }
  }
  return starts;
}

}  // namespace plumbline
