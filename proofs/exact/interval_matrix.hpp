#pragma once
/// \file
/// Vectors and matrices of intervals of 64 digits, beside doubles that are close to them.

#include <Eigen/Core>
#include <plumbline/base/interval.hpp>
#include <plumbline/base/number.hpp>

namespace plumbline::proofs {

using IntervalVector = Vector<Interval>;

/// As far as `radius` from a centre.
Interval around(double centre, double radius);

/// Y x
IntervalVector product(const Eigen::MatrixXd& Y, const IntervalVector& x);

/// 1 - Y A
Matrix<Interval> defect(const Eigen::MatrixXd& Y, const Matrix<Interval>& A);

/// Close to the inverse of the matrices in A; not finite where the middle one is singular.
Eigen::MatrixXd inverse_of_middle(const Matrix<Interval>& A);

}  // namespace plumbline::proofs
