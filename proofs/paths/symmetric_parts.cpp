#include "proofs/paths/symmetric_parts.hpp"

namespace plumbline::proofs {

namespace {

using Bounds = Vector<Span>;

/// sin(a x)/a and a sin(a x), and cos(a x).
struct Bend {
  Span share, times, cosine;
};

Bend bend(const Span& a, const Span& x) {
  const Span y = a * x, square = y * y;
  // sin y / y lies between 1 - y^2 / 6 and 1, cos y between 1 - y^2 / 2 and 1
  const double top = square.high;
  const Span ratio(Span::down(1 - Span::up(top / 6)), 1);
  return {x * ratio, a * a * x * ratio, {Span::down(1 - Span::up(top / 2)), 1}};
}

}  // namespace

SymmetricParts::SymmetricParts(const Chain<Interval>& chain, const Loading<Interval>& loading,
                               const Symmetry& symmetry)
    : n_(static_cast<Eigen::Index>(chain.size())),
      held_(loading.control == Control::end_point),
      size_(n_ + (held_ ? 2 : 0)),
      start_{Span(loading.start.x), Span(loading.start.y)},
      direction_{Span(loading.direction.x), Span(loading.direction.y)} {
  for (std::size_t i = 0; i < chain.size(); ++i) {
    length_.emplace_back(chain.length()[i]);
    stiffness_.emplace_back(chain.stiffness()[i]);
    rest_.emplace_back(chain.rest()[i]);
  }
  mean_ = basis(symmetry, 1);
  bend_ = basis(symmetry, -1);
}

/// Columns that span the shapes and forces with S u = sign u.
Eigen::MatrixXd SymmetricParts::basis(const Symmetry& symmetry, double sign) const {
  std::vector<Vector<double>> columns;
  const double own = symmetry.mirrored ? -sign : sign;
  for (Eigen::Index i = 0; i < n_; ++i) {
    const Eigen::Index other = symmetry.reversed ? n_ - 1 - i : i;
    Vector<double> column = Vector<double>::Zero(size_);
    column(i) += 1;
    column(other) += own;
    if (i <= other && column.squaredNorm() > 0) columns.push_back(column.normalized().cwiseSign());
  }
  for (Eigen::Index a = 0; held_ && a < 2; ++a) {
    if ((symmetry.mirrored && a == 1 ? -1 : 1) == static_cast<int>(sign))
      columns.push_back(Vector<double>::Unit(size_, n_ + a));
  }
  Eigen::MatrixXd B(size_, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j) B.col(static_cast<Eigen::Index>(j)) = columns[j];
  return B;
}

Parts SymmetricParts::at(const Bounds& m, const Span& load, const Bounds& v, const Span& a) const {
  const Bounds none = Bounds::Constant(size_, Span(0));
  const Matrix<Span> zero = Matrix<Span>::Constant(size_, size_, Span(0));
  Parts p{none, none, zero, zero, zero, zero, none, none};
  const Point<Span> ray{start_.x + load * direction_.x, start_.y + load * direction_.y};
  const Span Fx = held_ ? m(n_) : ray.x, Fy = held_ ? m(n_ + 1) : ray.y, gx = held_ ? v(n_) : Span(0),
             gy = held_ ? v(n_ + 1) : Span(0), square = a * a;
  if (held_) {
    p.even(n_) = -ray.x, p.even(n_ + 1) = -ray.y;
    p.even_by_load(n_) = -direction_.x, p.even_by_load(n_ + 1) = -direction_.y;
  }
  for (Eigen::Index i = 0; i < n_; ++i) {
    const auto at = static_cast<std::size_t>(i);
    // the spring at joint i turns link i and its predecessor
    const Span &k = stiffness_[at], turn = (i > 0 ? m(i) - m(i - 1) : m(i)) - rest_[at],
               more = i > 0 ? v(i) - v(i - 1) : v(i);
    for (const auto& [row, sign] : {std::pair<Eigen::Index, double>{i, 1.0}, {i - 1, -1.0}}) {
      if (row < 0) continue;
      p.even(row) += sign * (k * turn), p.odd(row) += sign * (k * more);
      for (const auto& [column, other] : {std::pair<Eigen::Index, double>{i, 1.0}, {i - 1, -1.0}}) {
        if (column < 0) continue;
        p.even_by_mean(row, column) += sign * other * k;
        p.odd_by_bend(row, column) += sign * other * k;
      }
    }
    const Span& L = length_[at];
    const Circle t = circle(m(i));
    const Bend b = bend(a, v(i));
    const Span x = L * t.cosine, y = L * t.sine, C = b.cosine, D = b.share, aS = b.times;
    p.even(i) += C * (Fx * y - Fy * x) + aS * (gx * x + gy * y);
    p.odd(i) += D * (Fx * x + Fy * y) + C * (gx * y - gy * x);
    p.even_by_mean(i, i) += C * (Fx * x + Fy * y) + aS * (gy * x - gx * y);
    p.odd_by_mean(i, i) += D * (Fy * x - Fx * y) + C * (gx * x + gy * y);
    // d/dv of cos(a v), a sin(a v), sin(a v) / a: -a sin(a v), a^2 cos(a v), cos(a v)
    p.even_by_bend(i, i) += aS * (Fy * x - Fx * y) + square * C * (gx * x + gy * y);
    p.odd_by_bend(i, i) += C * (Fx * x + Fy * y) + aS * (gy * x - gx * y);
    if (!held_) {
      p.even_by_load(i) += C * (direction_.x * y - direction_.y * x);
      p.odd_by_load(i) += D * (direction_.x * x + direction_.y * y);
      continue;
    }
    p.even_by_mean(i, n_) = C * y, p.even_by_mean(i, n_ + 1) = -(C * x);
    p.odd_by_mean(i, n_) = D * x, p.odd_by_mean(i, n_ + 1) = D * y;
    p.even_by_bend(i, n_) = aS * x, p.even_by_bend(i, n_ + 1) = aS * y;
    p.odd_by_bend(i, n_) = C * y, p.odd_by_bend(i, n_ + 1) = -(C * x);
    p.even(n_) += C * x, p.even(n_ + 1) += C * y;
    p.odd(n_) -= D * y, p.odd(n_ + 1) += D * x;
    p.even_by_mean(n_, i) = -(C * y), p.even_by_mean(n_ + 1, i) = C * x;
    p.odd_by_mean(n_, i) = -(D * x), p.odd_by_mean(n_ + 1, i) = -(D * y);
    p.even_by_bend(n_, i) = -(aS * x), p.even_by_bend(n_ + 1, i) = -(aS * y);
    p.odd_by_bend(n_, i) = -(C * y), p.odd_by_bend(n_ + 1, i) = C * x;
  }
  return p;
}

}  // namespace plumbline::proofs
