#include "proofs/paths/pitchfork.hpp"

#include <Eigen/LU>

#include "proofs/exact/inertia.hpp"
#include "proofs/paths/measures.hpp"
#include "proofs/paths/symmetric_parts.hpp"

namespace plumbline::proofs {

namespace {

using Bounds = Vector<Span>;

/// A x for an exact matrix.
Bounds applied(const Eigen::MatrixXd& A, const Bounds& x) {
  Bounds result = Bounds::Constant(A.rows(), Span(0));
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      if (A(i, j) != 0) result(i) += A(i, j) * x(j);
    }
  }
  return result;
}
Matrix<Span> applied(const Eigen::MatrixXd& A, const Matrix<Span>& X) {
  Matrix<Span> result(A.rows(), X.cols());
  for (Eigen::Index j = 0; j < X.cols(); ++j) result.col(j) = applied(A, Bounds(X.col(j)));
  return result;
}
/// A^T X B
Matrix<Span> between(const Eigen::MatrixXd& A, const Matrix<Span>& X, const Eigen::MatrixXd& B) {
  const Matrix<Span> left = applied(A.transpose(), X);
  return applied(B.transpose(), Matrix<Span>(left.transpose())).transpose();
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
class SymmetricEquations {
 public:
  SymmetricEquations(const SymmetricParts& system, Vector<double> scale)
      : system_(&system), scale_(std::move(scale)) {}

  [[nodiscard]] Linear symmetric(const Bounds& x, const Span& load) const {
    const Bounds none = Bounds::Constant(system_->size(), Span(0));
    const Parts p = system_->at(applied(system_->mean(), x), load, none, Span(0));
    const auto& B = system_->mean();
    return {applied(B.transpose(), p.even), between(B, p.even_by_mean, B)};
  }

  /// Unknowns: mean, load, bend.
  [[nodiscard]] Linear bent(const Bounds& w, const Span& a) const {
    const Eigen::MatrixXd &B = system_->mean(), &N = system_->bend_basis();
    const Eigen::Index means = B.cols(), bends = N.cols();
    const Parts p =
        system_->at(applied(B, Bounds(w.head(means))), w(means), applied(N, Bounds(w.tail(bends))), a);
    Linear all{Bounds(w.size()), Matrix<Span>::Constant(w.size(), w.size(), Span(0))};
    all.value.head(means) = applied(B.transpose(), p.even);
    all.value.segment(means, bends) = applied(N.transpose(), p.odd);
    Span scaled(-1);
    for (Eigen::Index j = 0; j < bends; ++j) scaled += scale_(j) * w(means + 1 + j);
    all.value(w.size() - 1) = scaled;
    auto& D = all.derivative;
    D.topLeftCorner(means, means) = between(B, p.even_by_mean, B);
    D.block(0, means, means, 1) = applied(B.transpose(), p.even_by_load);
    D.topRightCorner(means, bends) = between(B, p.even_by_bend, N);
    D.block(means, 0, bends, means) = between(N, p.odd_by_mean, B);
    D.block(means, means, bends, 1) = applied(N.transpose(), p.odd_by_load);
    D.block(means, means + 1, bends, bends) = between(N, p.odd_by_bend, N);
    for (Eigen::Index j = 0; j < bends; ++j) D(w.size() - 1, means + 1 + j) = Span(scale_(j));
    return all;
  }

 private:
  const SymmetricParts* system_;
  Vector<double> scale_;  ///< l
};

/// A point and how far off in each entry: it is in there.
Bounds around(const Vector<double>& x, double r) {
  return widened(x, Vector<double>::Constant(x.size(), r));
}

/// Newton's method, in double precision.
template <class Function>
Vector<double> newton(const Function& function, Vector<double> x) {
  for (int step = 0; step < 8; ++step) {
    const Linear here = function(around(x, 0));
    x -= middle(here.derivative).inverse() * here.value.unaryExpr([](const Span& y) { return y.middle(); });
  }
  return x;
}

/// A box around a point, found by widening, that Krawczyk's operator maps into its inside: for every
/// parameter it holds exactly one root, in `image`.
struct IsolatedRoot {
  Bounds box, image;
};

/// \param least  half the width to begin with
template <class Function>
std::optional<IsolatedRoot> isolated(const Function& function, const Vector<double>& centre,
                                     const Vector<double>& least) {
  const Linear here = function(around(centre, 0));
  const Eigen::MatrixXd Y = middle(here.derivative).inverse();
  if (!Y.allFinite()) return std::nullopt;
  const Vector<double> z = applied(Y, here.value).unaryExpr(magnitude_of);
  Vector<double> radius = (2 * z).cwiseMax(least);
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    const Bounds box = widened(centre, radius);
    Matrix<Span> defect = -applied(Y, function(box).derivative);
    for (Eigen::Index i = 0; i < z.size(); ++i) defect(i, i) += Span(1);
    Vector<double> image(z.size());
    for (Eigen::Index i = 0; i < z.size(); ++i) {
      Span sum(z(i));
      for (Eigen::Index j = 0; j < z.size(); ++j) sum += Span(defect(i, j).magnitude()) * Span(radius(j));
      image(i) = sum.high;
    }
    if (!image.allFinite()) return std::nullopt;
    if ((image.array() < radius.array()).all()) return IsolatedRoot{box, widened(centre, image)};
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

/// How far a box reaches from a point, entry by entry.
Vector<double> reach(const Bounds& box, const Vector<double>& centre) {
  return (box - centre.cast<Span>()).unaryExpr(magnitude_of);
}

/// The crossing of a symmetric branch and a bent one.
class PitchforkProver {
 public:
  PitchforkProver(const Chain<Interval>& chain, const Loading<Interval>& loading, const Symmetry& symmetry)
      : system_(chain, loading, symmetry),
        means_(system_.mean().cols()),
        bends_(system_.bend_basis().cols()) {}

  [[nodiscard]] std::optional<Fork> run(const Vector<double>& crossing, const std::vector<PieceEnd>& ends);

 private:
  [[nodiscard]] Vector<double> mean_of(const Vector<double>& point) const {
    return SymmetricParts::coordinates(system_.mean(), point.head(system_.size()));
  }
  [[nodiscard]] Vector<double> bend_of(const Vector<double>& point) const {
    return SymmetricParts::coordinates(system_.bend_basis(), point.head(system_.size()));
  }
  [[nodiscard]] static Span load_of(const PieceEnd& end) {
    return Span(end.point(end.point.size() - 1)) + Span(-end.distance, end.distance);
  }
  [[nodiscard]] bool is_bent(const PieceEnd& end) const {
    return bend_of(end.point).norm() > 100 * end.distance;
  }
  [[nodiscard]] Span amplitude_of(const PieceEnd& end, const Vector<double>& scale) const;
  [[nodiscard]] Bounds on_bent_branch(const PieceEnd& end, const Vector<double>& scale) const;
  [[nodiscard]] bool is_symmetric(const PieceEnd& end) const;

  SymmetricParts system_;
  Eigen::Index means_, bends_;
};

/// a = l · (a v) of an equilibrium near a point.
Span PitchforkProver::amplitude_of(const PieceEnd& end, const Vector<double>& scale) const {
  const Bounds bend = around(bend_of(end.point), end.distance);
  Span amplitude(0);
  for (Eigen::Index j = 0; j < bends_; ++j) amplitude += scale(j) * bend(j);
  return amplitude;
}

/// Mean, load and bend of an equilibrium near a point.
Bounds PitchforkProver::on_bent_branch(const PieceEnd& end, const Vector<double>& scale) const {
  Bounds reached(means_ + 1 + bends_);
  reached.head(means_) = around(mean_of(end.point), end.distance);
  reached(means_) = load_of(end);
  const Bounds bend = around(bend_of(end.point), end.distance);
  const Span amplitude = amplitude_of(end, scale);
  for (Eigen::Index j = 0; j < bends_; ++j) reached(means_ + 1 + j) = bend(j) / amplitude;
  return reached;
}

/// Whether an equilibrium near a point is symmetric: the only one at its load in a box that the symmetry
/// keeps.
bool PitchforkProver::is_symmetric(const PieceEnd& end) const {
  Eigen::MatrixXd both(system_.size(), system_.size());
  both << system_.mean(), system_.bend_basis();
  const Bounds none = Bounds::Constant(system_.size(), Span(0));
  Vector<double> centre(means_ + bends_);
  centre << mean_of(end.point), Vector<double>::Zero(bends_);
  const double off = bend_of(end.point).cwiseAbs().maxCoeff();
  const auto alone = isolated(
      [&](const Bounds& x) {
        const Parts p = system_.at(applied(both, x), load_of(end), none, Span(0));
        return Linear{applied(both.transpose(), p.even), between(both, p.even_by_mean, both)};
      },
      centre, Vector<double>::Constant(centre.size(), 2 * end.distance + 2 * off + 1e-14));
  return alone && inside(around(centre, end.distance + off), alone->box);
}

std::optional<Fork> PitchforkProver::run(const Vector<double>& crossing, const std::vector<PieceEnd>& ends) {
  Vector<double> scale;  // l, along the largest bend
  double amplitude = 0;
  for (const PieceEnd& end : ends) {
    const Vector<double> bend = bend_of(end.point);
    if (!is_bent(end) || bend.norm() <= amplitude) continue;
    amplitude = bend.norm();
    scale = bend / amplitude;
  }
  if (amplitude == 0) return std::nullopt;
  const SymmetricEquations equations(system_, scale);
  Vector<double> centre(means_ + 1 + bends_);
  centre << mean_of(crossing), crossing(crossing.size() - 1), scale;
  const auto bent = [&](const Span& a) { return [&, a](const Bounds& w) { return equations.bent(w, a); }; };
  centre = newton(bent(Span(0)), centre);
  if (!centre.allFinite()) return std::nullopt;

  // the bent branch, from its crossing with the symmetric one on
  Vector<double> least = Vector<double>::Constant(centre.size(), 1e-14);
  for (const PieceEnd& end : ends) {
    if (!is_bent(end)) continue;
    least = least.cwiseMax(2 * reach(on_bent_branch(end, scale), centre));
    amplitude = std::max(amplitude, amplitude_of(end, scale).magnitude());
  }
  const auto at_none = isolated(bent(Span(0)), centre, Vector<double>::Constant(centre.size(), 1e-14));
  const auto branch = isolated(bent(Span(0, amplitude)), centre, least);
  if (!at_none || !branch || !inside(at_none->image, branch->box)) return std::nullopt;
  Fork fork{at_none->image(means_), {}, {}};

  // the symmetric branch, all its shapes taken for symmetric ones
  Span loads = fork.load;
  Vector<double> start = centre.head(means_), least_mean = Vector<double>::Constant(means_, 1e-14);
  for (const PieceEnd& end : ends) {
    if (is_bent(end)) continue;
    loads = hull(loads, load_of(end));
    least_mean = least_mean.cwiseMax(2 * reach(around(mean_of(end.point), end.distance), start));
  }
  const auto symmetric =
      isolated([&](const Bounds& x) { return equations.symmetric(x, loads); }, start, least_mean);
  const bool crosses = symmetric && inside(Bounds(at_none->image.head(means_)), symmetric->box);

  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (is_bent(ends[i])) {
      if (inside(on_bent_branch(ends[i], scale), branch->box)) fork.bent.push_back(i);
    } else if (crosses && inside(around(mean_of(ends[i].point), ends[i].distance), symmetric->box) &&
               is_symmetric(ends[i])) {
      fork.symmetric.push_back(i);
    }
  }
  return fork;
}

}  // namespace

std::optional<Fork> pitchfork(const Chain<Interval>& chain, const Loading<Interval>& loading,
                              const Symmetry& symmetry, const Vector<double>& crossing,
                              const std::vector<PieceEnd>& ends) {
  const auto [bare, load] = without_units(chain, loading);
  return PitchforkProver(bare, load, symmetry).run(crossing, ends);
}

}  // namespace plumbline::proofs
