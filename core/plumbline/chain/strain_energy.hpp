#pragma once
/// \file
/// Elastic energy and joint torques of the springs, paper equations (10) and (24).
///
/// \code{.cpp}
/// // In equilibrium the springs' torques are J^T F: a chain that is held bent, and the force that holds it.
/// const Chain<double> chain({1, 1}, {0, 2});
/// const std::vector<double> q{0.25, -0.5};  // the end point lies on the x axis, and so does the force
/// const double force = -2 * 0.5 / std::sin(0.25);
/// const Vector<double> torque = spring_torque(chain, q);
/// const Vector<double> needed = jacobian(chain, q).transpose() * Eigen::Vector2d(force, 0);
/// assert((torque - needed).norm() < 1e-14);
/// assert(strain_energy(chain, q) == 0.25);
/// \endcode

#include <plumbline/chain/chain.hpp>

namespace plumbline {

/// E = sum_i k_i (q_i - rest_i)^2 / 2, in [k].
template <Number Real>
Real strain_energy(const Chain<Real>& chain, const std::vector<Real>& q) {
  Real twice(0);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Real d = q[i] - chain.rest()[i];
    twice = twice + chain.stiffness()[i] * (d * d);
  }
  return twice / Real(2);
}

/// The torque k_i (q_i - rest_i) that turns each spring. With the force F that the environment exerts on the
/// end point, the chain is in equilibrium where it equals J^T F.
template <Number Real>
Vector<Real> spring_torque(const Chain<Real>& chain, const std::vector<Real>& q) {
  Vector<Real> torque(static_cast<Eigen::Index>(chain.size()));
  for (std::size_t i = 0; i < chain.size(); ++i) {
    torque(static_cast<Eigen::Index>(i)) = chain.stiffness()[i] * (q[i] - chain.rest()[i]);
  }
  return torque;
}

}  // namespace plumbline
