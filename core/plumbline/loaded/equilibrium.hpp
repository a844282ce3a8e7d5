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

#include <plumbline/loaded/loaded_model.hpp>
#include <plumbline/loaded/loading.hpp>

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
  explicit EquilibriumSolver(const Model& model) : model_(&model) {}

  /// The equilibrium with its end point held at `place`, from a guess of shape and force.
  /// \throws Error out of reach, at a singular point, or where Newton's method does not settle
  Equilibrium<Real> at_end_point(const Point<Real>& place, Vector<Real> theta,
                                 Point<Real> force = {Real(0), Real(0)}) {
    model_->require_reach(place);
    return iterate(Control::end_point, place, std::move(theta), force);
  }

  /// The equilibrium under the force, from a guess of the shape.
  /// \throws Error at a singular point, or where Newton's method does not settle
  Equilibrium<Real> under_force(const Point<Real>& force, Vector<Real> theta) {
    return iterate(Control::force, {Real(0), Real(0)}, std::move(theta), force);
  }

  /// The tangent stiffness dF/dp (2 x 2; entry (0, 0) is dFx/dx at fixed y) at an equilibrium.
  /// \throws Error where it is infinite (one link) or the equilibrium is not isolated
  Eigen::Matrix<Real, 2, 2> tangent_stiffness(const Equilibrium<Real>& at) {
    model_->expand(at.theta, at.force, expansion_);
    require_regular(factor(Control::end_point));
    Eigen::Matrix<Real, 2, 2> stiffness;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      step_ = Vector<Real>::Constant(at.theta.size(), Real(0));
      Vector<Real> dF = Vector<Real>::Constant(2, Real(0));
      dF(axis) = Real(1);
      matrix_.solve(step_, dF);
      stiffness.col(axis) = -dF;
    }
    return stiffness;
  }

  /// The tangent compliance dp/dF (2 x 2) at an equilibrium.
  /// \throws Error where the equilibrium under that force is not isolated
  Eigen::Matrix<Real, 2, 2> tangent_compliance(const Equilibrium<Real>& at) {
    model_->expand(at.theta, at.force, expansion_);
    require_regular(factor(Control::force));
    Eigen::Matrix<Real, 2, 2> compliance = expansion_.compliance;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      step_ = expansion_.force_gradient.col(axis);
      matrix_.solve(step_, no_border_.col(0));
      compliance.col(axis) += expansion_.end_point_gradient.transpose() * step_;
    }
    return compliance;
  }

 private:
  // The unknown border is -F: with R = p' and C = -(force gradient) it makes the matrix symmetric,
  // [H J^T; J -A].
  bool factor(Control control) {
    matrix_.factor(expansion_.hessian);
    const Eigen::Index n = expansion_.hessian.cols();
    if (control == Control::end_point) {
      return matrix_.border(expansion_.force_gradient, expansion_.end_point_gradient,
                            Eigen::Matrix<Real, 2, 2>(-expansion_.compliance));
    }
    no_border_.resize(0, 1);
    const Matrix<Real> none(n, 0);
    return matrix_.border(none, none, Matrix<Real>(0, 0));
  }

  static void require_regular(bool regular) {
    if (!regular) throw Error("equilibrium", "a singular stiffness matrix", "an isolated equilibrium");
  }

  Equilibrium<Real> iterate(Control control, const Point<Real>& place, Vector<Real> theta,
                            Point<Real> force) {
    using std::abs, std::isfinite, std::max, std::sqrt;
    static constexpr int most = 200;
    const Real largest_turn = Real(1) / Real(2), enough = Real(64) * epsilon<Real>();
    Real last(1);
    for (int iteration = 0; iteration < most; ++iteration) {
      model_->expand(theta, force, expansion_);
      require_regular(is_finite(expansion_.energy) && factor(control));
      step_ = -expansion_.residual;
      Vector<Real> border(control == Control::end_point ? 2 : 0);
      if (control == Control::end_point)
        border << place.x - expansion_.end_point.x, place.y - expansion_.end_point.y;
      matrix_.solve(step_, border);
      Real moment(0), stiffness(0);
      for (Eigen::Index i = 0; i < theta.size(); ++i) {
        moment = max(moment, Real(abs(expansion_.residual(i))));
        stiffness = max(stiffness, Real(abs(expansion_.hessian(0, i))));
      }
      // a short turn alone does not settle it: the force may still have far to go
      const bool balanced = moment <= sqrt(epsilon<Real>()) * stiffness;
      Real turn(0), size(1);
      for (Eigen::Index i = 0; i < theta.size(); ++i) {
        turn = max(turn, Real(abs(step_(i))));
        size = max(size, Real(abs(theta(i))));
      }
      if (!is_finite(turn)) require_regular(false);
      const bool settled =
          balanced && (turn <= enough * size || (turn < sqrt(epsilon<Real>()) && turn > last / Real(2)));
      const Real part = turn > largest_turn ? Real(largest_turn / turn) : Real(1);
      theta += part * step_;
      if (control == Control::end_point) {
        force.x -= part * border(0);
        force.y -= part * border(1);
      }
      if (settled) return finish(control, std::move(theta), force);
      last = turn;
    }
    throw Error("equilibrium", "no convergence in " + std::to_string(most) + " Newton steps",
                "a guess nearer to an equilibrium");
  }

  Equilibrium<Real> finish(Control control, Vector<Real> theta, const Point<Real>& force) {
    model_->expand(theta, force, expansion_);
    require_regular(factor(control));
    const std::size_t borders = control == Control::end_point ? 2 : 0;
    const std::size_t negative = matrix_.negative(static_cast<Eigen::Index>(borders)) - borders;
    return {std::move(theta), force, expansion_.end_point, expansion_.energy, negative};
  }

  const Model* model_;
  Expansion<Real, bandwidth> expansion_;
  BorderedBand<Real, bandwidth> matrix_;
  Vector<Real> step_;
  Matrix<Real> no_border_;
};

}  // namespace plumbline
