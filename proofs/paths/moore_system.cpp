#include "proofs/paths/moore_system.hpp"

#include <Eigen/SVD>

#include "proofs/exact/as_double.hpp"
#include "proofs/exact/certain_digits.hpp"

namespace plumbline::proofs {
namespace {

using Index = Eigen::Index;

double size_of(const Interval& x) {
  return static_cast<double>(magnitude(x));
}

}  // namespace

MooreSystem::MooreSystem(const IntervalEquations& equations, const Vector<double>& crossing)
    : equations_(&equations), m_(equations.size()) {
  const IntervalVector none = IntervalVector::Constant(m_, Interval(0));
  const LocalEquations here =
      equations.at(crossing.unaryExpr([](double x) { return Interval::from_double(x); }), none);
  const Eigen::MatrixXd A = here.derivative.leftCols(m_).unaryExpr(&as_double);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  left_ = svd.matrixU().col(m_ - 1);
  right_ = svd.matrixV().col(m_ - 1);
}

std::optional<IntervalVector> MooreSystem::null_vectors(const IntervalVector& u) const {
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

std::pair<IntervalVector, Matrix<Interval>> MooreSystem::operator()(const IntervalVector& w) const {
  const Index size = 2 * m_ + 2;
  const IntervalVector psi = w.segment(m_ + 1, m_);
  const LocalEquations at = equations_->at(w.head(m_ + 1), psi);
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

}  // namespace plumbline::proofs
