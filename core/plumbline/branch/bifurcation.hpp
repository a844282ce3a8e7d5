#pragma once
/// \file
/// Where two branches cross: a simple bifurcation point, to working precision.
///
/// At such a point the derivative F_u of the equations F(u) = 0, u = (theta, F, load), loses one rank.
/// Bordered by two rows that span its null space and by one column psi0, it stays regular:
///
///     [ F_u  psi0 ] [ Phi ]   [ 0 ]
///     [ T     0   ] [  g  ] = [ I ] ,   and F_u is rank-deficient exactly where both numbers g vanish.
///
/// Newton's method solves F(u) + mu psi0 = 0, g(u) = 0 for u and mu. It converges where branches cross, and
/// also where they only nearly do: there mu, a moment that would have to act on the chain to make them meet,
/// is not zero. The second derivatives Q_ij = psi . F_uu Phi_i Phi_j decide what crosses: c^T Q c = 0 are the
/// tangents.

#include <Eigen/LU>
#include <plumbline/branch/branch.hpp>
#include <tuple>

namespace plumbline::detail {

/// A point where branches cross, and their tangents there.
template <Number Real>
struct Bifurcation {
  BranchPoint<Real> point;                ///< tangent: that of the branch it was found on
  std::vector<Variation<Real>> tangents;  ///< of the branches through it: two, or none if not simple
  Real imperfection;                      ///< mu, relative to the largest joint stiffness; 0 where they cross
  Real rounding;                          ///< what rounding alone can make of that

  /// Whether two branches cross here, as far as the digits tell.
  [[nodiscard]] bool simple() const { return tangents.size() == 2 && imperfection <= Real(64) * rounding; }
};

/// Finds the crossing next to a point of a branch.
template <SmoothModel Model>
class BifurcationSolver {
 public:
  /// The number type.
  using Real = typename Model::Real;

  /// For the model and the loading of a brancher, which has to outlive it.
  explicit BifurcationSolver(const Brancher<Model>& brancher) : brancher_(&brancher) {}

  /// The bifurcation near a point of a branch, with a guess of the direction that becomes singular.
  /// Nothing where Newton's method does not settle.
  std::optional<Bifurcation<Real>> near(BranchPoint<Real> point, const Variation<Real>& direction) {
    using std::abs, std::max, std::sqrt;
    n_ = point.theta.size();
    T_[0] = point.tangent;
    T_[1] = direction;
    psi0_ = brancher_->weighted(critical(point.tangent, direction));
    Real last = std::numeric_limits<Real>::max();
    const Real enough = sqrt(epsilon<Real>());
    for (int iteration = 0; iteration < 12; ++iteration) {
      if (!assemble(point)) return std::nullopt;
      Eigen::Matrix<Real, 2, 2> Q;
      const auto [newton, mu] = newton_step(point, Q);
      const Real size = brancher_->length(newton);
      if (!is_finite(size) || size > Real(1) || (iteration > 3 && size > last && last > enough))
        return std::nullopt;
      Brancher<Model>::move(point, newton, Real(1));
      if (last <= enough) {  // once more than it takes, for mu is that of the point before
        const Real unit = psi0_.cwiseAbs().maxCoeff() / at_.hessian.row(0).cwiseAbs().maxCoeff();
        return Bifurcation<Real>{point, tangents(Q), abs(mu) * unit, rounding(point) * unit};
      }
      last = size;
    }
    return std::nullopt;
  }

 private:
  static constexpr int bandwidth = Model::bandwidth;

  bool assemble(const BranchPoint<Real>& point) {
    brancher_->model().expand(point.theta, point.force, at_);
    Matrix<Real> C = Matrix<Real>::Constant(n_, 4, Real(0)), R = C, D = Matrix<Real>::Constant(4, 4, Real(0));
    brancher_->fill_borders(at_, C, R, D);
    C.col(3) = psi0_;
    for (Eigen::Index j = 0; j < 2; ++j) {
      R.col(2 + j) = brancher_->weighted(T_[j].theta);
      D(2 + j, 2) = brancher_->load_weight() * T_[j].load;
    }
    matrix_.factor(at_.hessian);
    transposed_.factor(at_.hessian);
    return matrix_.border(C, R, D) && transposed_.border(R, C, Matrix<Real>(D.transpose()));
  }

  /// The direction in which the chain can move at no change of the load: by the symmetry of the equations
  /// that is psi as well. At a crossing it is the combination of both tangents that leaves the load alone.
  static Vector<Real> critical(const Variation<Real>& a, const Variation<Real>& b) {
    Vector<Real> theta = b.load * a.theta - a.load * b.theta;
    const Real size = theta.cwiseAbs().maxCoeff();
    if (!(size > Real(0))) return b.theta;
    return theta / size;
  }

  /// Of mu = -psi . F, by the size of the terms that F is a sum of.
  Real rounding(const BranchPoint<Real>& point) const {
    using std::abs, std::max;
    const Real force = abs(point.force.x) + abs(point.force.y);
    const Real turn = max(Real(1), Real(point.theta.cwiseAbs().maxCoeff()));
    Real sum(0), reach(0);
    for (Eigen::Index i = 0; i < n_; ++i) {
      const Real link = abs(at_.end_point_gradient(i, 0)) + abs(at_.end_point_gradient(i, 1));
      sum += abs(psi_(i)) * (turn * abs(at_.hessian(0, i)) + force * link);
      reach += link;
    }
    const auto size = [](const Point<Real>& p) -> Real { return abs(p.x) + abs(p.y); };
    const Loading<Real>& loading = brancher_->loading();
    const bool held = loading.control == Control::end_point;
    const Real imposed = held ? reach : Real(force + abs(point.load) * size(loading.direction));
    return epsilon<Real>() * (sum + size(psi_place_) * imposed);
  }

  /// Solves with a right-hand side; the last unknown, beside the variation, is the multiplier of psi0.
  std::pair<Variation<Real>, Real> solve(Vector<Real> v, Vector<Real> w) {
    matrix_.solve(v, w);
    return {{std::move(v), {Real(-w(0)), Real(-w(1))}, w(2)}, w(3)};
  }

  /// psi . F_uu a b
  Real curvature(const BranchPoint<Real>& point, const Variation<Real>& a, const Variation<Real>& b) {
    Vector<Real> moment;
    Point<Real> place;
    brancher_->model().second_derivative(at_, point.force, a, b, moment, place);
    Real sum = psi_.dot(moment);
    if (brancher_->loading().control == Control::end_point)
      sum += psi_place_.x * place.x + psi_place_.y * place.y;
    return sum;
  }

  std::pair<Variation<Real>, Real> newton_step(const BranchPoint<Real>& point, Eigen::Matrix<Real, 2, 2>& Q) {
    const Vector<Real> none = Vector<Real>::Constant(n_, Real(0));
    const auto unit = [](Eigen::Index i) {
      Vector<Real> e = Vector<Real>::Constant(4, Real(0));
      e(i) = Real(1);
      return e;
    };
    Eigen::Matrix<Real, 2, 1> g;
    for (Eigen::Index j = 0; j < 2; ++j) std::tie(Phi_[j], g(j)) = solve(none, unit(2 + j));
    psi_ = none;
    Vector<Real> left = unit(3);
    transposed_.solve(psi_, left);
    psi_place_ = {left(0), left(1)};

    const Loading<Real>& loading = brancher_->loading();
    const Point<Real> wanted = loading.at(point.load);
    Vector<Real> w = Vector<Real>::Constant(4, Real(0));
    if (loading.control == Control::end_point)
      w(0) = wanted.x - at_.end_point.x, w(1) = wanted.y - at_.end_point.y;
    else
      w(0) = point.force.x - wanted.x, w(1) = point.force.y - wanted.y;
    auto [step, mu] = solve(-at_.residual, w);

    // g + g_u (step + Phi c) = 0, where g_u d = -psi . F_uu Phi d
    Eigen::Matrix<Real, 2, 1> right;
    for (Eigen::Index j = 0; j < 2; ++j) {
      for (Eigen::Index k = 0; k < 2; ++k) Q(j, k) = curvature(point, Phi_[j], Phi_[k]);
      right(j) = g(j) - curvature(point, Phi_[j], step);
    }
    const Eigen::Matrix<Real, 2, 1> c = Q.inverse() * right;
    for (int j = 0; j < 2; ++j) {
      step.theta += c(j) * Phi_[j].theta;
      step.force.x += c(j) * Phi_[j].force.x;
      step.force.y += c(j) * Phi_[j].force.y;
      step.load += c(j) * Phi_[j].load;
      mu += c(j) * g(j);
    }
    return {std::move(step), mu};
  }

  /// The two directions c with c^T Q c = 0, of unit length; none where Q is definite: an isolated point.
  [[nodiscard]] std::vector<Variation<Real>> tangents(const Eigen::Matrix<Real, 2, 2>& Q) const {
    using std::abs, std::sqrt;
    const Real &a = Q(0, 0), &b = Q(0, 1), &c = Q(1, 1), square = b * b - a * c;
    if (!(square > Real(0))) return {};
    const Real root =
        b < Real(0) ? Real(b - sqrt(square)) : Real(b + sqrt(square));  // a x^2 + 2 b x y + c y^2
    std::vector<Variation<Real>> result;
    for (const auto& [x, y] : {std::pair<Real, Real>{-root, a}, std::pair<Real, Real>{c, -root}}) {
      Variation<Real> t{
          x * Phi_[0].theta + y * Phi_[1].theta,
          {x * Phi_[0].force.x + y * Phi_[1].force.x, x * Phi_[0].force.y + y * Phi_[1].force.y},
          x * Phi_[0].load + y * Phi_[1].load};
      Brancher<Model>::scale(t, Real(1) / brancher_->length(t));
      result.push_back(std::move(t));
    }
    return result;
  }

  const Brancher<Model>* brancher_;
  Eigen::Index n_ = 0;
  Variation<Real> T_[2], Phi_[2];
  Vector<Real> psi0_, psi_;
  Point<Real> psi_place_;
  Expansion<Real, bandwidth> at_;
  BorderedBand<Real, bandwidth> matrix_, transposed_;
};

}  // namespace plumbline::detail
