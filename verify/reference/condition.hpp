#pragma once
/// \file
/// How much a critical force changes when the chain does.

#include <plumbline/chain/mode.hpp>

namespace plumbline::verify {

/// Relative condition number of a simple critical force: the largest relative change of the force per
/// relative change of the inputs, when every length and every stiffness may change by that much. It lies
/// between 2 and 6.
///
/// A mode makes sum k q^2 / 2 - F sum L theta^2 / 2 + F_y sum L theta stationary (29), (30), and is zero
/// there, so that the force changes by what the changed inputs add to it: dF sum L theta^2 = sum q_i^2 dk_i +
/// sum (2 F_y theta_j - F theta_j^2) dL_j.
template <Ordered Real>
Real condition_number(const Chain<Real>& chain, const Mode<Real>& mode) {
  const std::vector<Real> theta = orientations(mode.q);
  Real shortening(0), change(0);
  for (std::size_t j = 0; j < chain.size(); ++j) {
    const Real turned = mode.fy * theta[j] * Real(2) - mode.force * theta[j] * theta[j];
    shortening = shortening + chain.length()[j] * theta[j] * theta[j];
    change = change + chain.stiffness()[j] * mode.q[j] * mode.q[j];
    change = change + chain.length()[j] * (turned < Real(0) ? Real(-turned) : turned);
  }
  return change / (mode.force * shortening);
}

}  // namespace plumbline::verify
