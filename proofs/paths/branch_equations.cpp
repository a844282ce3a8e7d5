#include "proofs/paths/branch_equations.hpp"

#include "proofs/exact/inertia.hpp"

namespace plumbline::proofs {

namespace {

Span rounded(const Interval& x) {
  return Span(x);
}
Point<Span> rounded(const Point<Interval>& p) {
  return {Span(p.x), Span(p.y)};
}

}  // namespace

BranchEquations::BranchEquations(const Chain<Interval>& chain, const Loading<Interval>& loading)
    : model_(convert<Span>(chain, [](const Interval& x) { return rounded(x); })),
      loading_{loading.control, rounded(loading.start), rounded(loading.direction)},
      held_(loading.control == Control::end_point),
      n_(static_cast<Eigen::Index>(chain.size())),
      size_(n_ + (held_ ? 3 : 1)) {}

Vector<Span> BranchEquations::at(const BranchPoint<double>& point) const {
  Vector<Span> u(size_);
  u.head(n_) = point.theta.cast<Span>();
  if (held_) u(n_) = point.force.x, u(n_ + 1) = point.force.y;
  u(size_ - 1) = point.load;
  return u;
}

void BranchEquations::expand(const Vector<Span>& u) {
  force_ = held_ ? Point<Span>{u(n_), u(n_ + 1)} : loading_.at(load(u));
  model_.expand(u.head(n_), force_, at_);
}

Vector<Span> BranchEquations::value(const Vector<Span>& u) {
  expand(u);
  Vector<Span> E = Vector<Span>::Constant(size_, Span(0));
  E.head(n_) = at_.residual;
  if (held_) {
    const Point<Span> wanted = loading_.at(load(u));
    E(n_) = at_.end_point.x - wanted.x;
    E(n_ + 1) = at_.end_point.y - wanted.y;
  }
  return E;
}

Matrix<Span> BranchEquations::derivative(const Vector<Span>& u, const Vector<Span>& normal) {
  expand(u);
  Matrix<Span> M = Matrix<Span>::Constant(size_, size_, Span(0));
  const Point<Span>& d = loading_.direction;
  for (Eigen::Index i = 0; i < n_; ++i) {
    M(i, i) = at_.hessian(0, i);
    if (i + 1 < n_) M(i, i + 1) = M(i + 1, i) = at_.hessian(1, i);
    if (held_) {
      for (Eigen::Index a = 0; a < 2; ++a) {
        M(i, n_ + a) = -at_.force_gradient(i, a);
        M(n_ + a, i) = at_.end_point_gradient(i, a);
      }
    } else {
      M(i, n_) = -(at_.force_gradient(i, 0) * d.x + at_.force_gradient(i, 1) * d.y);
    }
  }
  if (held_) M(n_, n_ + 2) = -d.x, M(n_ + 1, n_ + 2) = -d.y;
  M.row(size_ - 1) = normal.transpose();
  return M;
}

Variation<Span> BranchEquations::variation(const Vector<Span>& v) const {
  const Span& load = v(size_ - 1);
  const Point<Span>& d = loading_.direction;
  return {v.head(n_), held_ ? Point<Span>{v(n_), v(n_ + 1)} : Point<Span>{load * d.x, load * d.y}, load};
}

Vector<Span> BranchEquations::second(const Vector<Span>& u, const Vector<Span>& v, const Vector<Span>& w) {
  expand(u);
  Vector<Span> moment;
  Point<Span> place;
  model_.second_derivative(at_, force_, variation(v), variation(w), moment, place);
  Vector<Span> result = Vector<Span>::Constant(size_, Span(0));
  result.head(n_) = moment;
  if (held_) result(n_) = place.x, result(n_ + 1) = place.y;
  return result;
}

/// Of y Fx - x Fy and of the sums of x and y, with x = L cos theta, y = L sin theta; the rest is linear.
Vector<Span> BranchEquations::third(const Vector<Span>& u, const Vector<Span>& v) {
  expand(u);
  const Point<Span> change = variation(v).force;
  Vector<Span> result = Vector<Span>::Constant(size_, Span(0));
  for (Eigen::Index i = 0; i < n_; ++i) {
    const Span x = at_.end_point_gradient(i, 1), y = -at_.end_point_gradient(i, 0), turn = v(i);
    const Span square = turn * turn, cube = square * turn;
    result(i) = -cube * (x * force_.x + y * force_.y) - Span(3) * square * (y * change.x - x * change.y);
    if (held_) result(n_) += y * cube, result(n_ + 1) -= x * cube;
  }
  return result;
}

StiffnessChange BranchEquations::stiffness(const Vector<Span>& u, const std::array<Vector<Span>, 3>& rates) {
  std::array<Span, 3> push, way;
  for (std::size_t k = 0; k < 3; ++k) {
    push[k] = held_ ? along(variation(rates[k]).force) : load(rates[k]);
    way[k] = load(rates[k]);
  }
  if (!held_) way = way_of_end_point(u, rates);
  return {way[0], push[0] * way[0], push[1] * way[0] - push[0] * way[1], push[2] * way[0] - push[0] * way[2]};
}

std::array<Span, 3> BranchEquations::way_of_end_point(const Vector<Span>& u,
                                                      const std::array<Vector<Span>, 3>& rates) {
  expand(u);
  std::array<Span, 3> way{Span(0), Span(0), Span(0)};
  for (Eigen::Index i = 0; i < n_; ++i) {
    const Span x = at_.end_point_gradient(i, 1), y = -at_.end_point_gradient(i, 0);
    const Span first = along({-y, x}), second = along({-x, -y});
    const Span &a = rates[0](i), &b = rates[1](i), &c = rates[2](i);
    way[0] += first * a;
    way[1] += first * b + second * a * a;
    way[2] += first * c + Span(3) * second * a * b - first * a * a * a;
  }
  return way;
}

std::optional<std::size_t> BranchEquations::negative_directions(const Vector<Span>& u) {
  expand(u);
  const Eigen::Index borders = held_ ? 2 : 0;
  Matrix<Span> K = Matrix<Span>::Constant(n_ + borders, n_ + borders, Span(0));
  for (Eigen::Index i = 0; i < n_; ++i) {
    K(i, i) = at_.hessian(0, i);
    if (i + 1 < n_) K(i, i + 1) = K(i + 1, i) = at_.hessian(1, i);
    for (Eigen::Index a = 0; a < borders; ++a) K(i, n_ + a) = K(n_ + a, i) = at_.end_point_gradient(i, a);
  }
  const auto negative = negative_eigenvalues(K);  // each border adds one
  if (!negative) return std::nullopt;
  return *negative - static_cast<std::size_t>(borders);
}

}  // namespace plumbline::proofs
