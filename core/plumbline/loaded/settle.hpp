#pragma once
/// \file
/// Where a chain comes to rest: the flow of the energy downhill, with equal viscous dampers at the joints.

#include <optional>
#include <plumbline/loaded/equilibrium.hpp>

namespace plumbline {

/// How the flow is followed.
template <Number Real>
struct FlowLimits {
  Real longest_turn;  ///< of one step, rad
  int most_steps;     ///< after which it is given up
};

/// Compliance of what holds the end point, over the damping: none where the force acts at that point. Where
/// it acts beside it, and may push it the wrong way, the force grows with what is missing of the way, until a
/// shape is found in which it pulls the point along.
template <LoadedModel Model>
typename Model::Real give_of(const LoadedSystem<Model>& system, const typename Model::Real& stiffest) {
  using Real = typename Model::Real;
  if (system.symmetric()) return Real(0);
  const Real arm = system.at().end_point_gradient.cwiseAbs().maxCoeff(),
             lever = system.at().force_gradient.cwiseAbs().maxCoeff();
  return arm * lever / (Real(100) * stiffest * stiffest);
}

/// Lets shape and force flow downhill in linearly implicit steps, (H + c D) dtheta = -residual on the
/// constraint: 1/c is a step's length in time, D the dampers' matrix. Steps grow while they turn the chain
/// little and the damped energy is convex.
/// \param stiffest  scale of the joints' stiffness, against which dampers count as strong or weak
/// \param between   called after every step; may change what the model is, such as contacts
/// \param at_rest   asked once the dampers are weak: whether the chain has arrived
/// \return whether it has
template <LoadedModel Model, class Between, class AtRest>
bool flow(LoadedSystem<Model>& system, Control control, const Point<typename Model::Real>& imposed,
          const typename Model::Real& stiffest, const FlowLimits<typename Model::Real>& limits,
          Vector<typename Model::Real>& theta, Point<typename Model::Real>& force, Between between,
          AtRest at_rest) {
  using Real = typename Model::Real;
  const Real weak = stiffest / Real(1000), strong = stiffest * Real(1e6), most = stiffest * Real(1e9);
  Real damping = Real(10) * stiffest;
  if (control == Control::force) force = imposed;
  for (int step = 0; step < limits.most_steps; ++step) {
    system.expand(theta, force);
    if (!system.factor(control, damping, Real(damping * give_of(system, stiffest))) ||
        system.negative_directions() > 0) {
      damping *= Real(4);
      if (damping > most) return false;
      continue;
    }
    const Real turn = system.step_to(imposed);
    if (!is_finite(turn)) return false;
    if (turn > limits.longest_turn && damping < strong) {
      damping *= Real(4);
      continue;
    }
    system.move(turn > limits.longest_turn ? Real(limits.longest_turn / turn) : Real(1), theta, force);
    between();
    damping /= Real(2);
    if (damping < weak && at_rest()) return true;
  }
  return false;
}

/// The stable equilibrium that a chain flows to from a shape, with its end point held (or under a force) at
/// `load` of the loading. Near a saddle the flow is slow; a shape exactly on one stays there until it is
/// pushed.
/// \throws Error where no equilibrium is reached, and out of reach
template <LoadedModel Model>
Equilibrium<typename Model::Real> settle(const Model& model, const Loading<typename Model::Real>& loading,
                                         const typename Model::Real& load, Vector<typename Model::Real> theta,
                                         Point<typename Model::Real> force = {}) {
  using Real = typename Model::Real;
  const Point<Real> imposed = loading.at(load);
  const Real longest_turn = Real(1) / Real(8);
  EquilibriumSolver<Model> solver(model);
  std::optional<Equilibrium<Real>> rest;
  // the flow ends where what is left of the way is short and downhill
  const auto at_rest = [&] {
    try {
      rest = solver.under(loading.control, imposed, theta, force);
    } catch (const Error&) {
      return false;  // no equilibrium that Newton's method finds from here
    }
    return rest->negative_directions == 0 && (rest->theta - theta).cwiseAbs().maxCoeff() < longest_turn;
  };
  if constexpr (requires { model.require_reach(imposed); }) {
    if (loading.control == Control::end_point) model.require_reach(imposed);
  }
  LoadedSystem<Model> system(model);
  system.expand(theta, {Real(0), Real(0)});  // the springs alone: at a fold the loaded chain has no stiffness
  const Real stiffest = system.at().hessian.row(0).cwiseAbs().maxCoeff();
  const FlowLimits<Real> limits{longest_turn, 5000};
  if (!flow(
          system, loading.control, imposed, stiffest, limits, theta, force, [] {}, at_rest))
    throw Error("flow", "no stable equilibrium within 5000 steps", "a chain that comes to rest");
  return *rest;
}

}  // namespace plumbline
