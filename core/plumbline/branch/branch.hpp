#pragma once
/// \file
/// The points of a branch of equilibria: corrected by Newton's method in a hyperplane (pseudo-arclength), and
/// expanded in power series, each in O(n).
///
/// How far a branch is free of surprises shows in the bordered matrix A of its equations. Along the tangent t
/// it changes, to leading order, by s D, D = A'(t); it is singular where -1/s is an eigenvalue of A^-1 D. A
/// few steps of power iteration bound that distance, the *horizon*. Where another branch comes near, or
/// crosses, A is nearly singular and the horizon closes in.

#include <cstdint>
#include <optional>
#include <plumbline/branch/branch_series.hpp>
#include <plumbline/loaded/equilibrium.hpp>

namespace plumbline {

/// Follows branches of one model under one loading. Keeps its storage.
template <SmoothModel Model>
class Brancher {
 public:
  /// The number type.
  using Real = typename Model::Real;
  /// Half-width of the model's Hessian.
  static constexpr int bandwidth = Model::bandwidth;

  /// \param shape  any shape of the chain, such as the unloaded one: sets the measure of arc length
  Brancher(const Model& model, Loading<Real> loading, const Vector<Real>& shape)
      : model_(&model), loading_(std::move(loading)) {
    using std::sqrt;
    model.expand(shape, {Real(0), Real(0)}, at_);
    const auto n = static_cast<Eigen::Index>(model.size());
    weight_.resize(n);
    Real length(0), softness(0);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Real x = at_.end_point_gradient(i, 0), y = at_.end_point_gradient(i, 1);
      weight_(i) = sqrt(x * x + y * y);
      length += weight_(i);
      if (at_.hessian(0, i) > Real(0)) softness += Real(1) / at_.hessian(0, i);
    }
    weight_ /= length;
    force_scale_ = Real(1) / (length * softness);
    const Real scale = loading_.control == Control::end_point ? length : force_scale_;
    load_weight_ = Real(1) / (scale * scale);
    C_ = Matrix<Real>::Constant(n, 3, Real(0));
    R_ = C_;
    D_ = Matrix<Real>::Constant(3, 3, Real(0));
    w_.resize(3);
    probe_.theta.resize(n);
    probe_.force = {Real(0), Real(0)};
    probe_.load = Real(0);
    for (Eigen::Index i = 0; i < n; ++i) probe_.theta(i) = noise();
  }

  /// The chain.
  [[nodiscard]] const Model& model() const { return *model_; }
  /// How it is loaded.
  [[nodiscard]] const Loading<Real>& loading() const { return loading_; }

  /// A change of angles as a functional, and the weight of the load, in that measure.
  [[nodiscard]] Vector<Real> weighted(const Vector<Real>& theta) const { return weight_.cwiseProduct(theta); }
  /// What the square of a load counts for in that measure.
  [[nodiscard]] const Real& load_weight() const { return load_weight_; }
  /// The load that counts as much as a turn of one radian.
  [[nodiscard]] Real load_scale() const {
    using std::sqrt;
    return Real(1) / sqrt(load_weight_);
  }
  /// Length in the branch's measure: root mean square turn, by link length, and load by its scale.
  [[nodiscard]] Real length(const Variation<Real>& v) const {
    using std::sqrt;
    return sqrt(product(v, v));
  }
  /// Inner product of that measure.
  [[nodiscard]] Real product(const Variation<Real>& a, const Variation<Real>& b) const {
    Real sum = load_weight_ * a.load * b.load;
    for (Eigen::Index i = 0; i < weight_.size(); ++i) sum += weight_(i) * a.theta(i) * b.theta(i);
    return sum;
  }

  /// The equilibrium at a load, from a guess of shape and force; tangent towards growing load.
  /// \throws Error out of reach, at a singular point, or where Newton's method does not settle
  BranchPoint<Real> start(const Real& load, const Vector<Real>& theta,
                          const Point<Real>& force = {Real(0), Real(0)}) {
    EquilibriumSolver<Model> solver(*model_);
    const bool held = loading_.control == Control::end_point;
    const Equilibrium<Real> found = held ? solver.at_end_point(loading_.at(load), theta, force)
                                         : solver.under_force(loading_.at(load), theta);
    BranchPoint<Real> point;
    point.load = load;
    point.theta = found.theta;
    point.force = found.force;
    if (!settle_on(point, at_load())) throw Error("branch", "a singular start", "an isolated equilibrium");
    return point;
  }

  /// The point of the same branch at a load near by. Nothing where Newton's method does not contract.
  std::optional<BranchPoint<Real>> at_load(BranchPoint<Real> point, const Real& load) {
    using std::abs;
    const Variation<Real> tangent = point.tangent;
    if (!(abs(tangent.load) > Real(0))) return std::nullopt;
    const Real ahead = (load - point.load) / tangent.load;
    move(point, tangent, ahead);
    point.load = load;
    if (!correct(point, at_load(), tangent, Real(abs(ahead) / Real(4)))) return std::nullopt;
    return point;
  }

  /// The point a length h ahead of (h < 0: behind) a point, measured along its tangent. Nothing where
  /// Newton's method does not contract at once, or the branch turns too much.
  std::optional<BranchPoint<Real>> step(const BranchPoint<Real>& from, const Real& h) {
    using std::abs;
    BranchPoint<Real> point = from;
    move(point, from.tangent, h);
    if (!correct(point, row(from.tangent), from.tangent, Real(abs(h) / Real(4)))) return std::nullopt;
    return point;
  }

  /// The branch around the point of the factors at hand; s is measured along the point's tangent.
  void expand(const BranchPoint<Real>& point, BranchSeries<Real>& series) {
    using std::abs, std::max, std::min, std::pow;
    const bool held = loading_.control == Control::end_point;
    const auto size = [](const Point<Real>& force) { return Real(abs(force.x) + abs(force.y)); };
    const Real force_unit = max(force_scale_, size(point.force));
    series.begin({point.theta, point.force, point.load}, at_.end_point);
    model_->begin_series(at_, series.order(), links_);
    series.reach = std::numeric_limits<Real>::max();
    for (Eigen::Index k = 1; k <= series.order(); ++k) {
      links_.lower_orders(k, series, v_, place_.x, place_.y);
      v_ = -v_;
      w_ << (held ? Real(-place_.x) : Real(0)), (held ? Real(-place_.y) : Real(0)), Real(k == 1 ? 1 : 0);
      const Variation<Real>& term = solution();
      const auto [x, y] = links_.turn(k, term.theta);
      series.set(k, term, {x, y});
      if (k + 2 > series.order()) {  // the last two: one may vanish, for symmetry's sake say
        // by largest entries, for the squares of a length would overflow where the series hardly converges
        const Real turn = max(Real(term.theta.cwiseAbs().maxCoeff()), Real(abs(term.load) / load_scale()));
        const Real last = max(turn, Real(size(term.force) / force_unit));
        if (last > Real(0))
          series.reach = min(
              series.reach, Real(pow(Real(4) * epsilon<Real>() / last, Real(1) / Real(static_cast<int>(k)))));
      }
    }
    series.complete(at_.energy, loading_);
  }

  /// The place s of a series as a point; its type is left open.
  BranchPoint<Real> along(BranchSeries<Real>& series, const Real& s) const {
    series.go_to(s);
    BranchPoint<Real> point = series.point();
    scale(point.tangent, Real(1) / length(point.tangent));
    return point;
  }

  /// A point beside a branch, brought onto it square to its tangent; then the factors at hand are its own.
  /// Nothing where it has to move farther than `farthest`, or Newton's method does not contract.
  std::optional<BranchPoint<Real>> onto(BranchPoint<Real> point, const Real& farthest) {
    const Variation<Real> tangent = point.tangent;
    if (!correct(point, row(tangent), tangent, farthest)) return std::nullopt;
    return point;
  }

  /// Makes the factors at hand those of a point.
  void refresh(const BranchPoint<Real>& point) { assemble(point, row(point.tangent)); }

  /// Fills in what is known of a point where the equations are singular, whose tangent is known otherwise.
  void describe_singular(BranchPoint<Real>& point, const Variation<Real>& tangent) {
    point.tangent = tangent;
    assemble(point, row(tangent));
    describe(point);
  }

  /// Distance along the tangent, ahead or behind, within which the equations stay regular, and the direction
  /// that becomes singular there; `ahead` is the signed distance if that direction is settled, else 0.
  struct Horizon {
    Real distance;              ///< to the nearest singular point, either way, in arc length
    Real ahead;                 ///< or 0
    Variation<Real> direction;  ///< where ahead is positive
  };

  /// The horizon at the point that was corrected last.
  Horizon horizon(const BranchPoint<Real>& point, int iterations) {
    using std::max;
    Horizon seen{};
    Real fastest(0);
    for (Eigen::Index i = 0; i < weight_.size(); ++i) probe_.theta(i) += noise() / Real(8);
    scale(probe_, Real(1) / length(probe_));
    for (int i = 0; i < iterations; ++i) {
      const Variation<Real>& image = change_of_equations(point, point.tangent, probe_);
      const Real growth = length(image), quotient = product(image, probe_);
      if (!(growth > Real(0))) break;
      fastest = max(fastest, growth);
      const Real off = growth * growth - quotient * quotient;  // squared length of image - quotient · probe
      seen.ahead = off < growth * growth / Real(16) ? Real(-1) / quotient : Real(0);
      probe_ = image;
      scale(probe_, Real(1) / growth);
    }
    seen.distance = fastest > Real(0) ? Real(1) / fastest : std::numeric_limits<Real>::max();
    if (seen.ahead > Real(0)) seen.direction = probe_;
    return seen;
  }

  /// Whether the force is still of a size that bends joints: less than a million times the chain's own.
  [[nodiscard]] bool force_bounded(const BranchPoint<Real>& point) const {
    using std::abs;
    return loading_.control == Control::force ||
           abs(point.force.x) + abs(point.force.y) < Real(1000000) * force_scale_;
  }

  /// The borders of the Hessian in the derivative of the equations: force and load, in the first two rows
  /// (columns of R) and the first three columns.
  void fill_borders(const Expansion<Real, bandwidth>& at, Matrix<Real>& C, Matrix<Real>& R,
                    Matrix<Real>& D) const {
    C.template leftCols<2>() = at.force_gradient;
    const bool held = loading_.control == Control::end_point;
    if (held) {
      R.template leftCols<2>() = at.end_point_gradient;
      D.template topLeftCorner<2, 2>() = -at.compliance;
    } else {
      D(0, 0) = D(1, 1) = Real(1);
    }
    D(0, 2) = held ? Real(-loading_.direction.x) : loading_.direction.x;
    D(1, 2) = held ? Real(-loading_.direction.y) : loading_.direction.y;
  }

  /// Takes a point along a variation, times h, off the branch.
  static void move(BranchPoint<Real>& point, const Variation<Real>& along, const Real& h) {
    point.theta += h * along.theta;
    point.force.x += h * along.force.x;
    point.force.y += h * along.force.y;
    point.load += h * along.load;
  }
  /// Multiplies a variation by a factor.
  static void scale(Variation<Real>& v, const Real& factor) {
    v.theta *= factor;
    v.force.x *= factor;
    v.force.y *= factor;
    v.load *= factor;
  }

 private:
  // The linear equations are A (dtheta, -dF, dload): the sign makes their leading part symmetric. The last
  // row says in which hyperplane the next point is sought.
  struct Row {
    Vector<Real> theta;
    Real load;
  };
  const Row& row(const Variation<Real>& tangent) {
    row_.theta = weight_.cwiseProduct(tangent.theta);
    row_.load = load_weight_ * tangent.load;
    return row_;
  }
  const Row& at_load() {
    row_.theta.setConstant(weight_.size(), Real(0));
    row_.load = Real(1);
    return row_;
  }

  bool assemble(const BranchPoint<Real>& point, const Row& last) {
    model_->expand(point.theta, point.force, at_);
    matrix_.factor(at_.hessian);
    fill_borders(at_, C_, R_, D_);
    R_.col(2) = last.theta;
    D_(2, 2) = last.load;
    return matrix_.border(C_, R_, D_);
  }

  /// What the equations lack at the point: right-hand side of a Newton step.
  void defect(const BranchPoint<Real>& point) {
    v_ = -at_.residual;
    const Point<Real> wanted = loading_.at(point.load);
    if (loading_.control == Control::end_point)
      w_ << wanted.x - at_.end_point.x, wanted.y - at_.end_point.y, Real(0);
    else
      w_ << point.force.x - wanted.x, point.force.y - wanted.y, Real(0);
  }
  const Variation<Real>& solution() {
    matrix_.solve(v_, w_);
    solved_.theta.swap(v_);
    solved_.force = {Real(-w_(0)), Real(-w_(1))};
    solved_.load = w_(2);
    return solved_;
  }
  /// The solution for the last row's right-hand side 1, all others 0: along the tangent.
  const Variation<Real>& tangent_solution() {
    v_.setConstant(weight_.size(), Real(0));
    w_ << Real(0), Real(0), Real(1);
    return solution();
  }

  /// Newton's method in a hyperplane, while it contracts; the factors at hand become those of the accepted
  /// point.
  /// \param farthest  longest first step that still counts as near
  bool correct(BranchPoint<Real>& point, const Row& plane, const Variation<Real>& tangent,
               const Real& farthest) {
    using std::sqrt;
    const Real settled = sqrt(epsilon<Real>());
    Real last(0);
    for (int iteration = 0; iteration < 8; ++iteration) {
      if (!assemble(point, plane)) return false;
      defect(point);
      const Variation<Real>& newton = solution();
      const Real size = length(newton);
      if (!is_finite(size)) return false;
      if (size > settled && size > (iteration == 0 ? farthest : Real(last / Real(4)))) return false;
      move(point, newton, Real(1));
      last = size;
      if (size <= settled) return assemble(point, plane) && finish(point, tangent);
    }
    return false;
  }

  /// Tangent, inertia and stiffness from the factors at hand.
  bool finish(BranchPoint<Real>& point, const Variation<Real>& towards) {
    using std::abs;
    const Real along = product(tangent_solution(), towards), size = length(solved_);
    if (!is_finite(size) || !(size > Real(0))) return false;
    point.tangent = solved_;
    scale(point.tangent, (along < Real(0) ? Real(-1) : Real(1)) / size);
    describe(point);
    return abs(along) > Real(4) / Real(5) * size * length(towards);
  }

  bool settle_on(BranchPoint<Real>& point, const Row& plane) {
    if (!assemble(point, plane)) return false;
    point.tangent = tangent_solution();
    const Real size = length(point.tangent);
    if (!is_finite(size)) return false;
    scale(point.tangent, Real(1) / size);
    describe(point);
    return true;
  }

  void describe(BranchPoint<Real>& point) {
    const std::size_t borders = loading_.control == Control::end_point ? 2 : 0;
    point.negative_directions = matrix_.negative(static_cast<Eigen::Index>(borders)) - borders;
    point.end_point = at_.end_point;
    point.energy = at_.energy;
    const Point<Real>& d = loading_.direction;
    const Variation<Real>& t = point.tangent;
    if (loading_.control == Control::end_point) {
      point.stiffness = (t.force.x * d.x + t.force.y * d.y) / t.load;
      return;
    }
    Real way(0);
    for (Eigen::Index i = 0; i < t.theta.size(); ++i)
      way += t.theta(i) * (at_.end_point_gradient(i, 0) * d.x + at_.end_point_gradient(i, 1) * d.y);
    point.stiffness = t.load / way;
  }

  /// A^-1 A'(v) w at the point of the factors at hand.
  Variation<Real>& change_of_equations(const BranchPoint<Real>& point, const Variation<Real>& v,
                                       const Variation<Real>& w) {
    model_->second_derivative(at_, point.force, v, w, v_, place_);
    w_ << place_.x, place_.y, Real(0);
    if (loading_.control == Control::force) w_.setConstant(Real(0));
    solution();
    return solved_;
  }

  /// Deterministic noise in [-1, 1]: keeps the probe from being blind to a direction, for symmetry's sake
  /// say.
  Real noise() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return Real(static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1.0);
  }

  const Model* model_;
  Loading<Real> loading_;
  Vector<Real> weight_;
  Real load_weight_, force_scale_;
  Expansion<Real, bandwidth> at_;
  BorderedBand<Real, bandwidth> matrix_;
  LinkSeries<Real> links_;
  Matrix<Real> C_, R_, D_;
  Vector<Real> v_, w_;
  Variation<Real> probe_, solved_;
  Point<Real> place_;
  Row row_;
  std::uint64_t state_ = 1;
};

}  // namespace plumbline
