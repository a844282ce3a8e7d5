#include "proofs/branch_equations.hpp"

#include "proofs/inertia.hpp"

namespace plumbline {

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

Vector<Span> BranchEquations::curvature(const Vector<Span>& u, const Vector<Span>& v) {
  expand(u);
  const Variation<Span> change = variation(v);
  Vector<Span> moment;
  Point<Span> place;
  model_.second_derivative(at_, force_, change, change, moment, place);
  Vector<Span> second = Vector<Span>::Constant(size_, Span(0));
  second.head(n_) = moment;
  if (held_) second(n_) = place.x, second(n_ + 1) = place.y;
  return second;
}

Span BranchEquations::answer(const Vector<Span>& u, const Vector<Span>& tangent) {
  const Point<Span>& d = loading_.direction;
  if (held_) return d.x * tangent(n_) + d.y * tangent(n_ + 1);
  expand(u);
  Span way(0);
  for (Eigen::Index i = 0; i < n_; ++i)
    way += tangent(i) * (at_.end_point_gradient(i, 0) * d.x + at_.end_point_gradient(i, 1) * d.y);
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

}  // namespace plumbline
