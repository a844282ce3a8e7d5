#pragma once
/// \file
/// Equilibria of a bent structure at a factor of its loads: by Newton's method, and where the energy flows.
///
/// What a support beside a clamp holds twice is left out exactly (implied_holds.hpp); axes in space may leave
/// others that depend on each other. So the rank of the constraints' gradients comes first: those that the
/// others imply take no part in the equations and are only asked to hold, and the negative directions are
/// those of the Hessian among the motions that are left. They say nothing at a singular shape
/// (singular_shape.hpp).
///
/// \code{.cpp}
/// // An upright cantilever of two links under more than its critical load 0.38 k / L leans to one side.
/// Structure<double> column(Chain<double>({1, 1}, {1, 1}));
/// column.end_point = {};
/// column.add_compression();
/// const auto model = bent_structure(column);
/// BentSolver<double> solver(model);
/// Vector<double> leaning(2);
/// leaning << 0.1, 0.1;
/// const auto rest = solver.settle(leaning, 0.5);
/// assert(rest && rest->negative_directions == 0 && rest->x(0) > 0.5);
/// \endcode

#include <optional>
#include <plumbline/space/singular_shape.hpp>

namespace plumbline {

/// A shape in which a structure is at rest under its loads at a factor.
template <Number Real>
struct BentPoint {
  Real factor;                          ///< of the loads that are multiplied
  Vector<Real> x;                       ///< the model's unknowns
  Vector<Real> multiplier;              ///< forces and moments that hold what is held
  std::size_t negative_directions = 0;  ///< in which the energy falls, of those that what is held permits
  Vector<Real> tangent_x;               ///< change of x along the branch through it
  Vector<Real> tangent_multiplier;      ///< change of the multipliers
  Real tangent_factor{0};  ///< change of the factor: together of length one in the branch's measure
};

/// Newton's method for one model. Dense, O(n^3) a step.
template <Floating Real>
class BentSolver {
 public:
  /// \param model  has to outlive the solver
  explicit BentSolver(const BentStructure<Real>& model) : model_(&model) {}

  /// What a change of the unknowns, of the multipliers and of the factor has to satisfy beside the linearised
  /// equations: row . change = right.
  struct Row {
    Vector<Real> x;           ///< of the unknowns
    Vector<Real> multiplier;  ///< of the multipliers
    Real factor;              ///< of the factor
    Real right;               ///< the sum that the products have to give
  };
  /// A change that keeps the factor.
  [[nodiscard]] Row keep_factor() const {
    return {Vector<Real>::Constant(model_->size(), Real(0)), Vector<Real>::Constant(model_->held(), Real(0)),
            Real(1), Real(0)};
  }

  /// The equilibrium near a point that satisfies row . (change from there) = right. Nothing where Newton's
  /// method does not contract.
  std::optional<BentPoint<Real>> correct(BentPoint<Real> point, const Row& row, int most = 30) {
    using std::abs;
    const BentPoint<Real> from = point;
    const Real enough = Real(1000) * epsilon<Real>();
    Real last(-1);
    for (int iteration = 0; iteration < most; ++iteration) {
      expand(point.x, point.factor, point.multiplier);
      Vector<Real> right(unknowns() + 1);
      right << -at_.gradient, asked(),
          row.right - row.x.dot(point.x - from.x) - row.multiplier.dot(point.multiplier - from.multiplier) -
              row.factor * (point.factor - from.factor);
      const Vector<Real> step = solve(row, right);
      const Real turn = step.head(model_->size()).cwiseAbs().maxCoeff();
      if (!is_finite(turn)) return std::nullopt;
      const Real part = turn > Real(1) / Real(2) ? Real(Real(1) / (Real(2) * turn)) : Real(1);
      add(point, Vector<Real>(part * step));
      if (turn <= enough || (last >= Real(0) && turn < Real(1e4) * enough && turn > last / Real(2)))
        return described(std::move(point), row);
      last = turn;
    }
    return std::nullopt;
  }
  /// The equilibrium at a factor from a guess.
  std::optional<BentPoint<Real>> at_factor(const Vector<Real>& x, const Real& factor,
                                           const Vector<Real>& multiplier) {
    return correct({factor, x, multiplier, 0, {}, {}, Real(0)}, keep_factor());
  }

  /// The stable equilibrium at a factor that the structure flows to from a shape, with equal dampers at all
  /// joints. Nothing where 20 000 linear systems reach none: a passive link under a moment turns for ever.
  std::optional<BentPoint<Real>> settle(Vector<Real> x, const Real& factor) {
    const Real longest = Real(1) / Real(8);
    Vector<Real> multiplier = Vector<Real>::Constant(model_->held(), Real(0));
    Real damping(-1);
    for (const std::size_t last = solves_ + 20'000; solves_ < last;) {
      expand(x, factor, multiplier);
      const Real stiffest = at_.hessian.diagonal().cwiseAbs().maxCoeff();
      if (damping < Real(0)) damping = Real(10) * stiffest;
      Matrix<Real> K = matrix(damping);
      Matrix<Real> counted = K;
      ++solves_;
      if (negative_eigenvalues(counted) > rank_) {
        damping *= Real(4);
        continue;
      }
      Vector<Real> right(unknowns());
      right << -at_.gradient, asked();
      const Vector<Real> change = K.partialPivLu().solve(right);
      const Real turn = change.head(model_->size()).cwiseAbs().maxCoeff();
      if (!is_finite(turn)) break;
      if (turn > longest && damping < Real(1e6) * stiffest) {
        damping *= Real(4);
        continue;
      }
      x += change.head(model_->size());
      multiplier -= change.tail(model_->held());
      damping /= Real(2);
      if (damping < stiffest / Real(1000)) {
        const auto rest = at_factor(x, factor, multiplier);
        if (rest && rest->negative_directions == 0 && (rest->x - x).cwiseAbs().maxCoeff() < longest)
          return rest;
      }
    }
    return std::nullopt;
  }

  /// The direction in which the equations are most nearly singular at fixed factor: unknowns of length one,
  /// at right angles to what is held.
  Vector<Real> weakest_direction(const BentPoint<Real>& point) {
    expand(point.x, point.factor, point.multiplier);
    const auto lu = matrix(Real(0)).fullPivLu();
    Vector<Real> v(unknowns());
    for (Eigen::Index i = 0; i < v.size(); ++i)
      v(i) = i >= model_->size() && implied(i - model_->size())
                 ? Real(0)
                 : Real(1) / Real(static_cast<double>(i) + 1.5);
    for (int step = 0; step < 8; ++step) {
      v = lu.solve(v).eval();
      v /= v.norm();
    }
    Vector<Real> x = v.head(model_->size());
    return x / x.norm();
  }

  /// How many linear systems have been solved.
  [[nodiscard]] std::size_t solves() const { return solves_; }
  /// The model whose equilibria are found.
  [[nodiscard]] const BentStructure<Real>& model() const { return *model_; }

 private:
  [[nodiscard]] Eigen::Index unknowns() const { return model_->size() + model_->held(); }

  void expand(const Vector<Real>& x, const Real& factor, const Vector<Real>& multiplier) {
    model_->expand(x, factor, multiplier, at_);
    const auto independent = detail::independent_rows(at_.held_gradient).row;
    rank_ = independent.size();
    implied_.assign(static_cast<std::size_t>(model_->held()), true);
    for (const Eigen::Index row : independent) implied_[static_cast<std::size_t>(row)] = false;
  }
  /// Whether a constraint follows from others at the shape that was expanded.
  [[nodiscard]] bool implied(Eigen::Index row) const { return implied_[static_cast<std::size_t>(row)]; }
  /// The changes of what is held that lead to where it is to be; of implied constraints, none.
  [[nodiscard]] Vector<Real> asked() const {
    Vector<Real> change = -at_.held;
    for (Eigen::Index i = 0; i < change.size(); ++i) {
      if (implied(i)) change(i) = Real(0);
    }
    return change;
  }
  /// Whether everything is held, what the others imply too, and every component of the forces is balanced:
  /// where constraints are dependent at one shape alone the equations may be solved without either.
  [[nodiscard]] bool at_rest(const Real& factor) const {
    const Real enough = Real(1e5) * epsilon<Real>();
    if (at_.held.size() > 0 && at_.held.cwiseAbs().maxCoeff() > enough * model_->reach()) return false;
    return !(at_.gradient.cwiseAbs().maxCoeff() > enough * model_->moment_scale(factor));
  }

  /// [H + damping, C^T; C, 0], whose second unknowns are minus the multipliers; a constraint that others
  /// imply has a one of its own in place of its row and column.
  [[nodiscard]] Matrix<Real> matrix(const Real& damping) const {
    const Eigen::Index n = model_->size(), c = model_->held();
    Matrix<Real> K = Matrix<Real>::Constant(n + c, n + c, Real(0));
    K.topLeftCorner(n, n) = at_.hessian;
    for (Eigen::Index i = 0; i < n; ++i) K(i, i) += damping;
    for (Eigen::Index i = 0; i < c; ++i) {
      if (implied(i)) {
        K(n + i, n + i) = Real(1);
      } else {
        K.block(n + i, 0, 1, n) = at_.held_gradient.row(i);
        K.block(0, n + i, n, 1) = at_.held_gradient.row(i).transpose();
      }
    }
    return K;
  }
  Vector<Real> solve(const Row& row, const Vector<Real>& right) {
    ++solves_;
    const Eigen::Index n = model_->size(), c = model_->held();
    Matrix<Real> A(n + c + 1, n + c + 1);
    A.topLeftCorner(n + c, n + c) = matrix(Real(0));
    A.col(n + c).setConstant(Real(0));
    A.col(n + c).head(n) = -at_.load;
    A.row(n + c).head(n) = row.x.transpose();
    A.row(n + c).segment(n, c) = -row.multiplier.transpose();
    A(n + c, n + c) = row.factor;
    return A.partialPivLu().solve(right);
  }
  void add(BentPoint<Real>& point, const Vector<Real>& step) const {
    point.x += step.head(model_->size());
    point.multiplier -= step.segment(model_->size(), model_->held());
    point.factor += step(unknowns());
  }
  /// Nothing where it is not at rest.
  std::optional<BentPoint<Real>> described(BentPoint<Real> point, const Row& row) {
    expand(point.x, point.factor, point.multiplier);
    if (!at_rest(point.factor)) return std::nullopt;
    Matrix<Real> K = matrix(Real(0));
    const std::size_t negative = negative_eigenvalues(K);
    point.negative_directions = negative > rank_ ? negative - rank_ : 0;
    Vector<Real> right = Vector<Real>::Constant(unknowns() + 1, Real(0));
    right(unknowns()) = Real(1);
    const Vector<Real> t = solve(row, right);
    point.tangent_x = t.head(model_->size());
    point.tangent_multiplier = -t.segment(model_->size(), model_->held());
    point.tangent_factor = t(unknowns());
    return point;
  }

  const BentStructure<Real>* model_;
  BentExpansion<Real> at_;
  std::size_t solves_ = 0;
  std::size_t rank_ = 0;       ///< of the constraints there
  std::vector<bool> implied_;  ///< which of them follow from the others
};

}  // namespace plumbline
