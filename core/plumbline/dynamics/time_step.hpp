#pragma once
/// \file
/// One step of an arm's motion in time, of second order, with dry friction that holds exactly.
///
/// Half a step of the coordinates, a whole one of the rates, half a step of the coordinates (Störmer-Verlet).
/// The rates solve M (v1 - v0) = h (drive - c - damping v1) - f with the dry friction f of dry_friction.hpp:
/// stuck joints have rate zero to the last bit, at any step length (Moreau's scheme of impulses).

#include <plumbline/dynamics/dry_friction.hpp>
#include <plumbline/dynamics/mass_matrix.hpp>

namespace plumbline {

/// What acts at the joints, in their order.
template <Floating Real>
struct JointForces {
  Vector<Real> drive;    ///< N m or N
  Vector<Real> damping;  ///< viscous, N m s/rad or N s/m, zero or positive
  Vector<Real> dry;      ///< sliding friction, N m or N, zero or positive
};

/// The state a time h later.
/// \param forces  callable with a state: the JointForces there
/// \code{.cpp}
/// SerialArm<double> slider;
/// slider.links.resize(1);
/// slider.links[0].kind = JointKind::prismatic;
/// slider.links[0].axis = {1, 0, 0};
/// slider.links[0].mass = 2;
/// const auto pushed = [](const ArmState<double>&) {
///   return JointForces<double>{Vector<double>::Constant(1, 3), Vector<double>::Zero(1),
///   Vector<double>::Constant(1, 4)};
/// };
/// const ArmState<double> rest{Vector<double>::Constant(1, 0.1), Vector<double>::Zero(1)};
/// assert(after(MovingArm<double>(slider), rest, 0.01, pushed).q(0) == 0.1);
/// \endcode
template <Floating Real, class Forces>
ArmState<Real> after(const MovingArm<Real>& moving, const ArmState<Real>& state, const Real& h,
                     Forces forces) {
  ArmState<Real> middle{state.q + h / 2 * state.v, state.v};
  const Matrix<Real> mass = mass_matrix(moving, middle.q);
  const Vector<Real> still = Vector<Real>::Zero(state.q.size());
  Vector<Real> next = state.v;
  for (int pass = 0; pass < 2; ++pass) {  // the second with the mean of the rates: of second order
    middle.v = (state.v + next) / 2;
    const JointForces<Real> acting = forces(middle);
    const Vector<Real> half = h / 2 * acting.damping;
    Matrix<Real> damped = mass;
    damped.diagonal() += half;
    const Vector<Real> momentum = mass * state.v - half.cwiseProduct(state.v) +
                                  h * (acting.drive - inverse_dynamics(moving, middle, still));
    next = rates_under_dry_friction<Real>(damped, momentum, h * acting.dry);
  }
  return {middle.q + h / 2 * next, next};
}

}  // namespace plumbline
