#pragma once
/// \file
/// Where a chain comes to rest: the flow of the energy downhill, with equal viscous dampers at the joints.

#include <plumbline/branch/branch.hpp>

namespace plumbline {

/// A model with dampers: stored energy plus c/2 sum (q_i - q_i(before))^2. Its equilibrium is one implicit
/// step, of length 1/c in time, of the flow dq/dt = -dE/dq on the constraint.
template <LoadedModel Model>
class DampedModel {
 public:
  using Real = typename Model::Real;
  static constexpr int bandwidth = Model::bandwidth;
  static_assert(bandwidth >= 1);

  DampedModel(const Model& model, Vector<Real> before, Real damping)
      : model_(&model), before_(std::move(before)), damping_(std::move(damping)) {}

  [[nodiscard]] std::size_t size() const { return model_->size(); }
  void require_reach(const Point<Real>& p) const { model_->require_reach(p); }

  void expand(const Vector<Real>& theta, const Point<Real>& force, Expansion<Real, bandwidth>& at) const {
    model_->expand(theta, force, at);
    const Vector<Real> turn = theta - before_;
    for (Eigen::Index i = 0; i < theta.size(); ++i) {
      const Real d = i > 0 ? Real(turn(i) - turn(i - 1)) : turn(i), torque = damping_ * d;
      at.energy += torque * d / Real(2);
      at.residual(i) += torque;
      at.hessian(0, i) += damping_;
      if (i > 0) {
        at.residual(i - 1) -= torque;
        at.hessian(0, i - 1) += damping_;
        at.hessian(1, i - 1) -= damping_;
      }
    }
  }

 private:
  const Model* model_;
  Vector<Real> before_;
  Real damping_;
};

/// The stable equilibrium that a chain flows to from a shape, with its end point held (or under a force) at
/// `load` of the loading. Near a saddle the flow is slow; a shape exactly on one stays there until it is
/// pushed. \throws Error where no equilibrium is reached, and out of reach
template <LoadedModel Model>
Equilibrium<typename Model::Real> settle(const Model& model, const Loading<typename Model::Real>& loading,
                                         const typename Model::Real& load, Vector<typename Model::Real> theta,
                                         Point<typename Model::Real> force = {}) {
  using Real = typename Model::Real;
  using std::abs, std::max;
  const bool held = loading.control == Control::end_point;
  const Point<Real> place = loading.at(load);
  const auto solve = [&](const auto& system) -> std::optional<Equilibrium<Real>> {
    EquilibriumSolver solver(system);
    try {
      return held ? solver.at_end_point(place, theta, force) : solver.under_force(place, theta);
    } catch (const Error&) {
      return std::nullopt;  // no equilibrium that Newton's method finds from here
    }
  };
  if (held) model.require_reach(place);
  const auto turned = [&](const Equilibrium<Real>& to) {
    Real most(0);
    for (Eigen::Index i = 0; i < theta.size(); ++i) most = max(most, Real(abs(to.theta(i) - theta(i))));
    return most;
  };
  const Real short_turn = Real(1) / Real(50), long_turn = Real(1) / Real(8);
  Expansion<Real, Model::bandwidth> at;
  model.expand(theta, {Real(0), Real(0)},
               at);  // the springs alone: at a fold the loaded chain has no stiffness
  Real stiffest(0);
  for (Eigen::Index i = 0; i < at.hessian.cols(); ++i) stiffest = max(stiffest, Real(abs(at.hessian(0, i))));
  Real damping = Real(4) * stiffest;
  for (int step = 0; step < 5000 && damping < stiffest * Real(1e12); ++step) {
    const auto next = solve(DampedModel<Model>(model, theta, damping));
    if (!next || next->negative_directions > 0 || turned(*next) > long_turn) {
      damping *= Real(4);
      continue;
    }
    if (turned(*next) < short_turn) {
      const auto rest = solve(model);
      // the flow ends here if what is left of the way is short and downhill
      if (rest && rest->negative_directions == 0 && turned(*rest) < long_turn) return *rest;
      damping /= Real(2);
    }
    theta = next->theta;
    force = next->force;
  }
  throw Error("flow", "no stable equilibrium within 5000 steps", "a chain that comes to rest");
}

}  // namespace plumbline
