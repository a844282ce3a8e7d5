#pragma once
/// \file
/// One equilibrium of a chain under load, paper equations (6), (8), (12), (22), by Newton's method in O(n) a
/// step.
///
/// Two ways to load. Imposed end point: theta and the reaction force F are unknown, stability is the inertia
/// of the energy's Hessian on the tangent space of the constraint. Imposed force: theta is unknown, stability
/// is the inertia of the full Hessian. What is stable under an imposed force is stable with its end point
/// held; the converse fails.
///
/// \code{.cpp}
/// // The paper's Z-chain, its end point pushed in by 0.1.
/// const std::vector<double> rest{-0.2417, 0.6821, -0.7958, 0.5170};
/// const NominalModel<double> model(Chain<double>({1, 1, 1, 1}, {1, 1, 1, 1}, rest));
/// EquilibriumSolver<NominalModel<double>> solver(model);
/// const Point<double> start = end_point(model.chain(), rest);
/// const auto found = solver.at_end_point({start.x - 0.1, start.y}, absolute_angles(rest));
/// assert(std::abs(found.end_point.x - (start.x - 0.1)) < 1e-12);
/// assert(found.negative_directions == 0 && found.force.x < 0);  // stable; compression
/// \endcode

#include <plumbline/loaded/loaded_system.hpp>

namespace plumbline {

/// A shape in which a loaded chain is at rest, stable or not.
template <Number Real>
struct Equilibrium {
  Vector<Real> theta;               ///< absolute angles, n
  Point<Real> force;                ///< exerted on the end point by the environment
  Point<Real> end_point;            ///< where the end point is
  Real energy;                      ///< stored energy
  std::size_t negative_directions;  ///< of the Hessian, in the sense of the control; 0 is stable
};

/// Newton's method on one model. Keeps its storage: many solves cost no allocation.
template <LoadedModel Model>
class EquilibriumSolver {
 public:
  /// The number type.
  using Real = typename Model::Real;
  /// Half-width of the model's Hessian.
  static constexpr int bandwidth = Model::bandwidth;

  /// For a model, which has to outlive it.
  explicit EquilibriumSolver(const Model& model) : model_(&model), system_(model) {}

  /// The equilibrium with its end point held at `place`, from a guess of shape and force.
  /// \throws Error out of reach, at a singular point, or where Newton's method does not settle
  Equilibrium<Real> at_end_point(const Point<Real>& place, Vector<Real> theta,
                                 Point<Real> force = {Real(0), Real(0)}) {
    if constexpr (requires { model_->require_reach(place); }) model_->require_reach(place);
    return iterate(Control::end_point, place, std::move(theta), force);
  }

  /// The equilibrium under the force, from a guess of the shape.
  /// \throws Error at a singular point, or where Newton's method does not settle
  Equilibrium<Real> under_force(const Point<Real>& force, Vector<Real> theta) {
    return iterate(Control::force, force, std::move(theta), force);
  }

  /// Either, by the control.
  Equilibrium<Real> under(Control control, const Point<Real>& imposed, Vector<Real> theta,
                          const Point<Real>& force) {
    return control == Control::end_point ? at_end_point(imposed, std::move(theta), force)
                                         : under_force(imposed, std::move(theta));
  }

  /// The tangent stiffness dF/dp (2 x 2; entry (0, 0) is dFx/dx at fixed y) at an equilibrium.
  /// \throws Error where it is infinite (one link) or the equilibrium is not isolated
  Eigen::Matrix<Real, 2, 2> tangent_stiffness(const Equilibrium<Real>& at) {
    system_.expand(at.theta, at.force);
    require_regular(system_.factor(Control::end_point));
    Eigen::Matrix<Real, 2, 2> stiffness;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      Vector<Real> turn = Vector<Real>::Constant(at.theta.size(), Real(0));
      Vector<Real> dF = Vector<Real>::Constant(2, Real(0));
      dF(axis) = Real(1);
      system_.solve(turn, dF);
      stiffness.col(axis) = -dF;
    }
    return stiffness;
  }

  /// The tangent compliance dp/dF (2 x 2) at an equilibrium.
  /// \throws Error where the equilibrium under that force is not isolated
  Eigen::Matrix<Real, 2, 2> tangent_compliance(const Equilibrium<Real>& at) {
    system_.expand(at.theta, at.force);
    require_regular(system_.factor(Control::force));
    Eigen::Matrix<Real, 2, 2> compliance = system_.at().compliance;
    Vector<Real> none(0);
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      Vector<Real> turn = system_.at().force_gradient.col(axis);
      system_.solve(turn, none);
      compliance.col(axis) += system_.at().end_point_gradient.transpose() * turn;
    }
    return compliance;
  }

 private:
  static void require_regular(bool regular) {
    if (!regular) throw Error("equilibrium", "a singular stiffness matrix", "an isolated equilibrium");
  }

  Equilibrium<Real> iterate(Control control, const Point<Real>& imposed, Vector<Real> theta,
                            Point<Real> force) {
    using std::abs, std::max, std::sqrt;
    static constexpr int most = 200;
    const Real largest_turn = Real(1) / Real(2), enough = Real(64) * epsilon<Real>();
    Real last(1);
    for (int iteration = 0; iteration < most; ++iteration) {
      system_.expand(theta, force);
      require_regular(is_finite(system_.at().energy) && system_.factor(control));
      const Real turn = system_.step_to(imposed);
      require_regular(is_finite(turn));
      Real moment(0), stiffness(0), size(1);
      for (Eigen::Index i = 0; i < theta.size(); ++i) {
        moment = max(moment, Real(abs(system_.at().residual(i))));
        stiffness = max(stiffness, Real(abs(system_.at().hessian(0, i))));
        size = max(size, Real(abs(theta(i))));
      }
      // a short turn alone does not settle it: the force may still have far to go
      const bool balanced = moment <= sqrt(epsilon<Real>()) * stiffness;
      const bool settled =
          balanced && (turn <= enough * size || (turn < sqrt(epsilon<Real>()) && turn > last / Real(2)));
      system_.move(turn > largest_turn ? Real(largest_turn / turn) : Real(1), theta, force);
      if (settled) return finish(control, std::move(theta), force);
      last = turn;
    }
    throw Error("equilibrium", "no convergence in " + std::to_string(most) + " Newton steps",
                "a guess nearer to an equilibrium");
  }

  Equilibrium<Real> finish(Control control, Vector<Real> theta, const Point<Real>& force) {
    system_.expand(theta, force);
    require_regular(system_.factor(control));
    return {std::move(theta), force, system_.at().end_point, system_.at().energy,
            system_.negative_directions()};
  }

  const Model* model_;
  LoadedSystem<Model> system_;
};

}  // namespace plumbline
