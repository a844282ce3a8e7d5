#include "proofs/unfolding.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include "proofs/as_double.hpp"
#include "proofs/certain_digits.hpp"
#include "proofs/measures.hpp"

namespace plumbline::proofs {
namespace {

using IntervalVector = Vector<Interval>;
using Index = Eigen::Index;

double size_of(const Interval& x) {
  return static_cast<double>(magnitude(x));
}
Interval around(double centre, double radius) {
  return Interval::from_double(centre) + Interval(Interval::End(-radius), Interval::End(radius));
}

/// E, its derivative by all unknowns, and psi · E''.
struct Local {
  IntervalVector value;
  Matrix<Interval> derivative, bend;
};

/// Equations and unknowns as in BranchEquations, in the numbers of Interval.
class IntervalEquations {
 public:
  IntervalEquations(const Chain<Interval>& chain, const Loading<Interval>& loading)
      : chain_(&chain),
        loading_(&loading),
        n_(static_cast<Index>(chain.size())),
        held_(loading.control == Control::end_point) {}

  /// How many equations: one less than unknowns.
  [[nodiscard]] Index size() const { return n_ + (held_ ? 2 : 0); }

  [[nodiscard]] Local at(const IntervalVector& u, const IntervalVector& psi) const {
    const Index m = size();
    Local all{IntervalVector::Constant(m, Interval(0)), Matrix<Interval>::Constant(m, m + 1, Interval(0)),
              Matrix<Interval>::Constant(m + 1, m + 1, Interval(0))};
    const Point<Interval>& d = loading_->direction;
    const Point<Interval> ray{loading_->start.x + u(m) * d.x, loading_->start.y + u(m) * d.y};
    const Point<Interval> force = held_ ? Point<Interval>{u(n_), u(n_ + 1)} : ray;
    springs(u, all);
    if (held_) {
      all.value(n_) = -ray.x, all.value(n_ + 1) = -ray.y;
      all.derivative(n_, m) = -d.x, all.derivative(n_ + 1, m) = -d.y;
    }
    for (Index i = 0; i < n_; ++i) link(i, force, u(i), psi, all);
    return all;
  }

 private:
  void springs(const IntervalVector& u, Local& all) const {
    for (Index i = 0; i < n_; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Interval &k = chain_->stiffness()[at],
                     moment = k * ((i > 0 ? u(i) - u(i - 1) : u(i)) - chain_->rest()[at]);
      all.value(i) = all.value(i) + moment;
      all.derivative(i, i) = all.derivative(i, i) + k;
      if (i == 0) continue;
      all.value(i - 1) = all.value(i - 1) - moment;
      all.derivative(i - 1, i - 1) = all.derivative(i - 1, i - 1) + k;
      all.derivative(i, i - 1) = all.derivative(i - 1, i) = -k;
    }
  }

  /// What link i contributes: L (Fx sin theta - Fy cos theta) to its moment, L (cos, sin) theta to the end
  /// point.
  void link(Index i, const Point<Interval>& force, const Interval& theta, const IntervalVector& psi,
            Local& all) const {
    const Index m = size();
    const Interval& L = chain_->length()[static_cast<std::size_t>(i)];
    const Interval x = L * cos(theta), y = L * sin(theta);
    const Interval pull = force.x * y - force.y * x;
    auto& bend = all.bend;
    all.value(i) = all.value(i) + pull;
    all.derivative(i, i) = all.derivative(i, i) + force.x * x + force.y * y;
    bend(i, i) = -(psi(i) * pull);
    if (!held_) {
      const Point<Interval>& d = loading_->direction;
      all.derivative(i, m) = d.x * y - d.y * x;
      bend(i, m) = bend(m, i) = psi(i) * (d.x * x + d.y * y);
      return;
    }
    all.value(n_) = all.value(n_) + x, all.value(n_ + 1) = all.value(n_ + 1) + y;
    all.derivative(i, n_) = y, all.derivative(i, n_ + 1) = -x;
    all.derivative(n_, i) = -y, all.derivative(n_ + 1, i) = x;
    bend(i, i) = bend(i, i) - psi(n_) * x - psi(n_ + 1) * y;
    bend(i, n_) = bend(n_, i) = psi(i) * x;
    bend(i, n_ + 1) = bend(n_ + 1, i) = psi(i) * y;
  }

  const Chain<Interval>* chain_;
  const Loading<Interval>* loading_;
  Index n_;
  bool held_;
};

IntervalVector product(const Eigen::MatrixXd& Y, const IntervalVector& x) {
  IntervalVector result = IntervalVector::Constant(Y.rows(), Interval(0));
  for (Index i = 0; i < Y.rows(); ++i) {
    for (Index j = 0; j < Y.cols(); ++j) result(i) = result(i) + Interval::from_double(Y(i, j)) * x(j);
  }
  return result;
}

/// 1 - Y A
Matrix<Interval> defect(const Eigen::MatrixXd& Y, const Matrix<Interval>& A) {
  Matrix<Interval> D(Y.rows(), A.cols());
  for (Index j = 0; j < A.cols(); ++j) {
    D.col(j) = -product(Y, IntervalVector(A.col(j)));
    D(j, j) = D(j, j) + Interval(1);
  }
  return D;
}

Eigen::MatrixXd inverse_of_middle(const Matrix<Interval>& A) {
  return A.unaryExpr(&as_double).inverse();
}

class Moore {
 public:
  Moore(const IntervalEquations& equations, const Vector<double>& crossing)
      : equations_(&equations), m_(equations.size()) {
    const IntervalVector none = IntervalVector::Constant(m_, Interval(0));
    const Local here =
        equations.at(crossing.unaryExpr([](double x) { return Interval::from_double(x); }), none);
    const Eigen::MatrixXd A = here.derivative.leftCols(m_).unaryExpr(&as_double);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    left_ = svd.matrixU().col(m_ - 1);
    right_ = svd.matrixV().col(m_ - 1);
  }

  /// All psi with psi^T dE/dx = 0, b · psi = 1 at any u in a box; nothing where that is open.
  [[nodiscard]] std::optional<IntervalVector> null_vectors(const IntervalVector& u) const {
    const Matrix<Interval> A =
        equations_->at(u, IntervalVector::Constant(m_, Interval(0))).derivative.leftCols(m_);
    Matrix<Interval> bordered = Matrix<Interval>::Constant(m_ + 1, m_ + 1, Interval(0));
    bordered.topLeftCorner(m_, m_) = A.transpose();
    for (Index i = 0; i < m_; ++i) {
      bordered(i, m_) = Interval::from_double(right_(i));
      bordered(m_, i) = Interval::from_double(left_(i));
    }
    const Eigen::MatrixXd Y = inverse_of_middle(bordered);
    if (!Y.allFinite()) return std::nullopt;
    // x = Y r + (1 - Y B) x for the right side r; so x - Y r is at most |D| |Y r| / (1 - |D|)
    double norm = 0, most = 0;
    const Matrix<Interval> D = defect(Y, bordered);
    for (Index i = 0; i <= m_; ++i) {
      double sum = 0;
      for (Index j = 0; j <= m_; ++j) sum += size_of(D(i, j));
      norm = std::max(norm, sum);
      most = std::max(most, std::abs(Y(i, m_)));
    }
    if (!(norm < 0.5)) return std::nullopt;
    IntervalVector psi(m_);
    for (Index i = 0; i < m_; ++i) psi(i) = around(Y(i, m_), 3 * norm * most);
    return psi;
  }

  /// w = (u, psi, tau)
  [[nodiscard]] std::pair<IntervalVector, Matrix<Interval>> operator()(const IntervalVector& w) const {
    const Index size = 2 * m_ + 2;
    const IntervalVector psi = w.segment(m_ + 1, m_);
    const Local at = equations_->at(w.head(m_ + 1), psi);
    IntervalVector f = IntervalVector::Constant(size, Interval(0));
    Matrix<Interval> D = Matrix<Interval>::Constant(size, size, Interval(0));
    f(size - 1) = Interval(-1);
    for (Index i = 0; i < m_; ++i) {
      const Interval b = Interval::from_double(left_(i));
      f(i) = at.value(i) + w(size - 1) * b;
      f(size - 1) = f(size - 1) + b * psi(i);
      D(i, size - 1) = D(size - 1, m_ + 1 + i) = b;
      for (Index j = 0; j <= m_; ++j) {
        D(i, j) = at.derivative(i, j);
        f(m_ + j) = f(m_ + j) + psi(i) * at.derivative(i, j);
        D(m_ + j, m_ + 1 + i) = at.derivative(i, j);
      }
    }
    D.block(m_, 0, m_ + 1, m_ + 1) = at.bend;
    return {f, D};
  }

 private:
  const IntervalEquations* equations_;
  Index m_;
  Vector<double> left_, right_;
};

}  // namespace

bool unfolded(const Chain<Interval>& chain, const Loading<Interval>& loading, const Vector<double>& crossing,
              double distance) {
  const auto [bare, load] = without_units(chain, loading);
  const IntervalEquations equations(bare, load);
  const Index m = equations.size();
  const Moore moore(equations, crossing);
  IntervalVector w(2 * m + 2);
  w.head(m + 1) = crossing.unaryExpr([=](double x) { return around(x, distance); });
  const auto psi = moore.null_vectors(w.head(m + 1));
  if (!psi) return false;
  w.segment(m + 1, m) = *psi;
  w(2 * m + 1) = Interval(Interval::End(-distance), Interval::End(distance));

  constexpr int rounds = 12;  // the width is squared in each
  bool one = false;           // root of Moore's system in the box
  for (int round = 0; round < rounds; ++round) {
    const IntervalVector centre =
        w.unaryExpr([](const Interval& x) { return Interval(x.middle(), x.middle()); });
    const IntervalVector step = moore(centre).first;
    const Matrix<Interval> A = moore(w).second;
    const Eigen::MatrixXd Y = inverse_of_middle(A);
    if (!Y.allFinite()) return false;
    IntervalVector image = centre - product(Y, step);
    const Matrix<Interval> D = defect(Y, A);
    bool inside = true;
    for (Index i = 0; i < w.size(); ++i) {
      for (Index j = 0; j < w.size(); ++j) image(i) = image(i) + D(i, j) * (w(j) - centre(j));
      inside = inside && image(i).inside(w(i));
    }
    one = one || inside;
    if (one && !image(2 * m + 1).contains_zero()) return true;
    for (Index i = 0; i < w.size(); ++i) {
      if (certainly_less(image(i), w(i)) || certainly_less(w(i), image(i))) return false;
      w(i) = Interval(std::max(image(i).lower(), w(i).lower()), std::min(image(i).upper(), w(i).upper()));
    }
  }
  return false;
}

}  // namespace plumbline::proofs
