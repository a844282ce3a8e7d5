#pragma once
/// \file
/// The equations of equilibrium of a loaded model, linearised at one shape and force: what Newton's method,
/// damped motion and tangent stiffness all solve with, in O(n).

#include <plumbline/loaded/loaded_model.hpp>
#include <plumbline/loaded/loading.hpp>

namespace plumbline {

/// Residual, derivatives and factors at the place where the model was expanded last. With the end point held,
/// the unknowns are theta and F, the equations
///
///     [ H    C ] [ dtheta ]   [ -residual ]     C = force gradient, J = end point's derivative,
///     [ J   -A ] [  -dF   ] = [ wanted - p ] ,  A = compliance
///
/// and symmetric but for eccentric loads; under a force they are H dtheta = -residual. Keeps its storage.
template <LoadedModel Model>
class LoadedSystem {
 public:
  using Real = typename Model::Real;                  ///< kind of number
  static constexpr int bandwidth = Model::bandwidth;  ///< of the Hessian
  /// Of a model that outlives this.
  explicit LoadedSystem(const Model& model) : model_(&model) {}
  /// \param smallest_pivot  see BorderedBand
  LoadedSystem(const Model& model, const Real& smallest_pivot) : model_(&model), matrix_(smallest_pivot) {}

  /// Evaluates the model.
  void expand(const Vector<Real>& theta, const Point<Real>& force) { model_->expand(theta, force, at_); }
  /// Residual and end point alone, where a model can give them by themselves; the factors stay: a chord step.
  void balance(const Vector<Real>& theta, const Point<Real>& force) { model_->balance(theta, force, at_); }
  [[nodiscard]] const Expansion<Real, bandwidth>& at() const { return at_; }  ///< as last expanded

  /// Factors the equations. `damping`: of equal viscous dampers between the angles, added to H; `give`: of
  /// what holds the end point, added to A.
  /// \return whether they are regular
  bool factor(Control control, const Real& damping = Real(0), const Real& give = Real(0)) {
    held_ = control == Control::end_point;
    const Eigen::Index n = at_.residual.size();
    if (damping > Real(0)) {
      for (Eigen::Index i = 0; i < n; ++i) {
        at_.hessian(0, i) += i + 1 < n ? Real(damping + damping) : damping;
        if (i + 1 < n) at_.hessian(1, i) -= damping;
      }
    }
    matrix_.factor(at_.hessian);
    if (!held_) return matrix_.no_border();
    Eigen::Matrix<Real, 2, 2> corner = -at_.compliance;
    corner.diagonal().array() -= give;
    return matrix_.border(at_.force_gradient, at_.end_point_gradient, corner);
  }

  /// Directions in which the (damped) energy falls away, in the sense of the control; 0 at a stable place.
  /// What acts beside the point that is held has no energy, and may push it the wrong way: whatever holds it
  /// then drives it on. Each such direction counts too.
  [[nodiscard]] std::size_t negative_directions() {
    if (!held_) return matrix_.negative(0);
    const std::size_t negative = matrix_.negative(2);
    return negative < 2 ? 2 - negative : negative - 2;
  }
  /// Whether the force acts at the point that is held, as last expanded.
  [[nodiscard]] bool symmetric() const { return at_.force_gradient == at_.end_point_gradient; }

  /// Replaces (v, w), the right-hand side, by the solution; w is -dF, and empty under a force.
  template <class V, class W>
  void solve(V&& v, W&& w) {
    matrix_.solve(v, w);
  }

  /// The step of Newton's method towards the equilibrium with the end point at `place`, or under the force.
  /// \return its longest turn; not finite where the step is not
  Real step_to(const Point<Real>& place) {
    using std::abs;
    turn_ = -at_.residual;
    if (held_) {
      border_.resize(2);
      border_ << place.x - at_.end_point.x, place.y - at_.end_point.y;
    } else {
      border_.resize(0);
    }
    matrix_.solve(turn_, border_);
    push_ = held_ ? Point<Real>{Real(-border_(0)), Real(-border_(1))} : Point<Real>{Real(0), Real(0)};
    if (!is_finite(push_.x) || !is_finite(push_.y)) return push_.x + push_.y;
    Real longest(0);
    for (Eigen::Index i = 0; i < turn_.size(); ++i) {
      const Real size = abs(turn_(i));
      if (!is_finite(size)) return size;
      if (size > longest) longest = size;
    }
    return longest;
  }
  [[nodiscard]] const Vector<Real>& turn() const { return turn_; }  ///< of that step, by link
  [[nodiscard]] const Point<Real>& push() const { return push_; }   ///< of that step: the force

  /// Goes a part of that step.
  void move(const Real& part, Vector<Real>& theta, Point<Real>& force) const {
    theta += part * turn_;
    force.x += part * push_.x;
    force.y += part * push_.y;
  }

 private:
  const Model* model_;
  Expansion<Real, bandwidth> at_;
  BorderedBand<Real, bandwidth> matrix_;
  bool held_ = true;
  Vector<Real> turn_, border_;
  Point<Real> push_{Real(0), Real(0)};
};

}  // namespace plumbline
