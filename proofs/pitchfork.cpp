#include "proofs/pitchfork.hpp"

#include <Eigen/LU>

#include "proofs/inertia.hpp"

namespace plumbline::proofs {

namespace {

using Bounds = Vector<Span>;

/// The parts of E(m + a v) and their derivatives, for all angles and both components of the force.
struct Parts {
  Bounds even, odd;  ///< the odd one over a
  Matrix<Span> even_by_mean, even_by_bend, odd_by_mean, odd_by_bend;
  Bounds even_by_load, odd_by_load;
};

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

class System {
 public:
  System(const Chain<Interval>& chain, const Loading<Interval>& loading, const Symmetry& symmetry)
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

  [[nodiscard]] Eigen::Index size() const { return size_; }
  [[nodiscard]] const Eigen::MatrixXd& mean() const { return mean_; }
  [[nodiscard]] const Eigen::MatrixXd& bend_basis() const { return bend_; }
  /// Angles and force of a point, without its load.
  [[nodiscard]] Vector<double> at(const BranchPoint<double>& point) const {
    Vector<double> u(size_);
    u.head(n_) = point.theta;
    if (held_) u(n_) = point.force.x, u(n_ + 1) = point.force.y;
    return u;
  }
  /// Coordinates of the part of u in a basis of orthogonal columns.
  static Vector<double> coordinates(const Eigen::MatrixXd& basis, const Vector<double>& u) {
    return (basis.transpose() * u).cwiseQuotient(basis.colwise().squaredNorm().transpose());
  }

  [[nodiscard]] Parts parts(const Bounds& m, const Span& load, const Bounds& v, const Span& a) const;

 private:
  /// Columns that span the shapes and forces with S u = sign u.
  [[nodiscard]] Eigen::MatrixXd basis(const Symmetry& symmetry, double sign) const {
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

  Eigen::Index n_;
  bool held_;
  Eigen::Index size_;
  Point<Span> start_, direction_;
  std::vector<Span> length_, stiffness_, rest_;
  Eigen::MatrixXd mean_, bend_;
};

Parts System::parts(const Bounds& m, const Span& load, const Bounds& v, const Span& a) const {
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

/// A x for an exact matrix.
Bounds product(const Eigen::MatrixXd& A, const Bounds& x) {
  Bounds result = Bounds::Constant(A.rows(), Span(0));
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      if (A(i, j) != 0) result(i) += A(i, j) * x(j);
    }
  }
  return result;
}
Matrix<Span> product(const Eigen::MatrixXd& A, const Matrix<Span>& X) {
  Matrix<Span> result(A.rows(), X.cols());
  for (Eigen::Index j = 0; j < X.cols(); ++j) result.col(j) = product(A, Bounds(X.col(j)));
  return result;
}
/// A^T X B
Matrix<Span> between(const Eigen::MatrixXd& A, const Matrix<Span>& X, const Eigen::MatrixXd& B) {
  const Matrix<Span> left = product(A.transpose(), X);
  return product(B.transpose(), Matrix<Span>(left.transpose())).transpose();
}

Bounds widened(const Vector<double>& centre, const Vector<double>& radius) {
  Bounds box(centre.size());
  for (Eigen::Index i = 0; i < centre.size(); ++i) box(i) = Span(centre(i)) + Span(-radius(i), radius(i));
  return box;
}

struct Linear {
  Bounds value;
  Matrix<Span> derivative;
};

/// Equations for symmetric shapes at a load, or for mean, load and bend at an amplitude.
class Equations {
 public:
  Equations(const System& system, Vector<double> scale) : system_(&system), scale_(std::move(scale)) {}

  [[nodiscard]] Linear symmetric(const Bounds& x, const Span& load) const {
    const Bounds none = Bounds::Constant(system_->size(), Span(0));
    const Parts p = system_->parts(product(system_->mean(), x), load, none, Span(0));
    const auto& B = system_->mean();
    return {product(B.transpose(), p.even), between(B, p.even_by_mean, B)};
  }

  /// Unknowns: mean, load, bend.
  [[nodiscard]] Linear bent(const Bounds& w, const Span& a) const {
    const Eigen::MatrixXd &B = system_->mean(), &N = system_->bend_basis();
    const Eigen::Index means = B.cols(), bends = N.cols();
    const Parts p =
        system_->parts(product(B, Bounds(w.head(means))), w(means), product(N, Bounds(w.tail(bends))), a);
    Linear all{Bounds(w.size()), Matrix<Span>::Constant(w.size(), w.size(), Span(0))};
    all.value.head(means) = product(B.transpose(), p.even);
    all.value.segment(means, bends) = product(N.transpose(), p.odd);
    Span scaled(-1);
    for (Eigen::Index j = 0; j < bends; ++j) scaled += scale_(j) * w(means + 1 + j);
    all.value(w.size() - 1) = scaled;
    auto& D = all.derivative;
    D.topLeftCorner(means, means) = between(B, p.even_by_mean, B);
    D.block(0, means, means, 1) = product(B.transpose(), p.even_by_load);
    D.topRightCorner(means, bends) = between(B, p.even_by_bend, N);
    D.block(means, 0, bends, means) = between(N, p.odd_by_mean, B);
    D.block(means, means, bends, 1) = product(N.transpose(), p.odd_by_load);
    D.block(means, means + 1, bends, bends) = between(N, p.odd_by_bend, N);
    for (Eigen::Index j = 0; j < bends; ++j) D(w.size() - 1, means + 1 + j) = Span(scale_(j));
    return all;
  }

 private:
  const System* system_;
  Vector<double> scale_;  ///< l
};

double magnitude(const Span& x) {
  return x.magnitude();
}

/// A box around a point, found by widening, that Krawczyk's operator maps into its inside: for every
/// parameter it holds exactly one root, in `image`.
struct Isolated {
  Bounds box, image;
};

template <class Function>
std::optional<Isolated> isolated(const Function& function, Vector<double> centre,
                                 const Vector<double>& least) {
  const auto point = [](const Vector<double>& x) { return Bounds(x.cast<Span>()); };
  Eigen::MatrixXd Y;
  for (int step = 0; step < 8; ++step) {
    const Linear here = function(point(centre));
    Y = middle(here.derivative).inverse();
    if (!Y.allFinite()) return std::nullopt;
    centre -= Y * here.value.unaryExpr([](const Span& x) { return x.middle(); });
  }
  const Vector<double> z = product(Y, function(point(centre)).value).unaryExpr(&magnitude);
  Vector<double> radius = (2 * z).cwiseMax(least);
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    const Bounds box = widened(centre, radius);
    Matrix<Span> defect = -product(Y, function(box).derivative);
    for (Eigen::Index i = 0; i < z.size(); ++i) defect(i, i) += Span(1);
    Vector<double> image(z.size());
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      Span sum(z(i));
      for (Eigen::Index j = 0; j < z.size(); ++j) sum += Span(defect(i, j).magnitude()) * Span(radius(j));
      image(i) = sum.high;
    }
    if (!image.allFinite()) return std::nullopt;
    if ((image.array() < radius.array()).all()) return Isolated{box, widened(centre, image)};
    radius = (2 * image).cwiseMax(least);
  }
  return std::nullopt;
}

bool inside(const Bounds& a, const Bounds& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!a(i).inside(b(i))) return false;
  }
  return true;
}

}  // namespace

std::optional<Span> pitchfork(const Chain<Interval>& chain, const Loading<Interval>& loading,
                              const Symmetry& symmetry, const Near& before,
                              const BranchPoint<double>& crossing, const Near& after) {
  const System system(chain, loading, symmetry);
  const Eigen::MatrixXd &B = system.mean(), &N = system.bend_basis();
  const Eigen::Index means = B.cols(), bends = N.cols();
  if (bends == 0) return std::nullopt;
  const Vector<double> bent = System::coordinates(N, system.at(after.point));
  const double amplitude = bent.norm();
  if (!(amplitude > 100 * after.distance)) return std::nullopt;
  const Equations equations(system, bent / amplitude);
  const auto scattered = [](const Vector<double>& x, double r) {
    return widened(x, Vector<double>::Constant(x.size(), r));
  };

  // from no amplitude to that of the point on the bent branch
  const Span a(0, amplitude * 1.001);
  Vector<double> centre(means + 1 + bends);
  centre << System::coordinates(B, system.at(crossing)), crossing.load, bent / amplitude;
  const auto fork =
      isolated([&](const Bounds& w) { return equations.bent(w, a); }, centre,
               Vector<double>::Constant(centre.size(), 1e-12 + 100 * after.distance / amplitude));
  if (!fork) return std::nullopt;
  Bounds reached(centre.size());
  reached.head(means) = scattered(System::coordinates(B, system.at(after.point)), 2 * after.distance);
  reached(means) = Span(after.point.load) + Span(-after.distance, after.distance);
  const Span there = Span(amplitude) + Span(-2 * after.distance, 2 * after.distance) * Span(double(bends));
  const Bounds turned = scattered(bent, 2 * after.distance);
  for (Eigen::Index j = 0; j < bends; ++j) reached(means + 1 + j) = turned(j) / there;
  if (!inside(reached, fork->box)) return std::nullopt;

  // where it leaves the symmetric branch
  const auto at_none = isolated([&](const Bounds& w) { return equations.bent(w, Span(0)); }, centre,
                                Vector<double>::Constant(centre.size(), 1e-14));
  if (!at_none || !inside(at_none->image, fork->box)) return std::nullopt;
  const Span load = at_none->image(means);

  // the symmetric branch from the point before to there
  const Vector<double> start = System::coordinates(B, system.at(before.point));
  const Span loads = hull(load, Span(before.point.load) + Span(-before.distance, before.distance));
  const auto symmetric = isolated([&](const Bounds& x) { return equations.symmetric(x, loads); }, start,
                                  Vector<double>::Constant(means, 1e-12));
  if (!symmetric || !inside(scattered(start, 2 * before.distance), symmetric->box) ||
      !inside(Bounds(at_none->image.head(means)), symmetric->box))
    return std::nullopt;

  // the point before is symmetric: it is the only equilibrium at its load in a box that the symmetry keeps
  const Vector<double> off = System::coordinates(N, system.at(before.point));
  Vector<double> all(means + bends);
  all << start, Vector<double>::Zero(bends);
  Eigen::MatrixXd both(system.size(), system.size());
  both << B, N;
  const Span at_load = Span(before.point.load) + Span(-before.distance, before.distance);
  const Bounds none = Bounds::Constant(system.size(), Span(0));
  const auto alone = isolated(
      [&](const Bounds& x) {
        const Parts p = system.parts(product(both, x), at_load, none, Span(0));
        return Linear{product(both.transpose(), p.even), between(both, p.even_by_mean, both)};
      },
      all, Vector<double>::Constant(all.size(), 4 * before.distance + 2 * off.norm() + 1e-12));
  if (!alone) return std::nullopt;
  Bounds found(all.size());
  found.head(means) = scattered(start, 2 * before.distance);
  found.tail(bends) = scattered(off, 2 * before.distance);
  Bounds image = found;
  image.tail(bends) = -found.tail(bends);
  if (!inside(found, alone->box) || !inside(image, alone->box)) return std::nullopt;
  return load;
}

}  // namespace plumbline::proofs
