#include "proofs/exact/interval_matrix.hpp"

#include <Eigen/LU>

#include "proofs/exact/as_double.hpp"

namespace plumbline::proofs {
namespace {

using Index = Eigen::Index;

}  // namespace

Interval around(double centre, double radius) {
  return Interval::from_double(centre) + Interval(Interval::End(-radius), Interval::End(radius));
}

IntervalVector product(const Eigen::MatrixXd& Y, const IntervalVector& x) {
  IntervalVector result = IntervalVector::Constant(Y.rows(), Interval(0));
  for (Index i = 0; i < Y.rows(); ++i) {
    for (Index j = 0; j < Y.cols(); ++j) result(i) = result(i) + Interval::from_double(Y(i, j)) * x(j);
  }
  return result;
}

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

}  // namespace plumbline::proofs
