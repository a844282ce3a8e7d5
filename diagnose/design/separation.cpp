#include "diagnose/design/separation.hpp"

#include <Eigen/Core>

#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {

LinearisedAlternative linearised_alternative(const Fit& truth, const Fit& alternative) {
  LinearisedAlternative rows;
  const auto count = static_cast<Eigen::Index>(truth.whitened.size());
  rows.slope = alternative.jacobian;
  rows.difference.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    rows.difference(i) = alternative.whitened[k] - truth.whitened[k];
  }
  // A parameter at its bound cannot move further.
  for (std::size_t p = 0; p < alternative.at_bound.size(); ++p)
    if (alternative.at_bound[p]) rows.slope.col(static_cast<Eigen::Index>(p)).setZero();
  return rows;
}

double separation(const LinearisedAlternative& rows) {
  if (rows.slope.cols() == 0) return rows.difference.squaredNorm();
  // Columns of unit length make the rank decision independent of units.
  const Eigen::VectorXd norm = rows.slope.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd unit = rows.slope * norm.cwiseInverse().asDiagonal();
  const Eigen::VectorXd step = LeastSquares(unit).solve(rows.difference);
  return (rows.difference - unit * step).squaredNorm();
}

LinearisedAlternative reduced(const LinearisedAlternative& rows) {
  const Eigen::Index count = rows.slope.cols();
  Eigen::MatrixXd all(rows.difference.size(), count + 1);
  all.leftCols(count) = rows.slope;
  all.rightCols(1) = rows.difference;
  const Eigen::MatrixXd factor = triangular_factor(all);
  return {factor.col(count), factor.leftCols(count)};
}

LinearisedAlternative stacked(const LinearisedAlternative& a, const LinearisedAlternative& b) {
  LinearisedAlternative both;
  both.difference.resize(a.difference.size() + b.difference.size());
  both.difference << a.difference, b.difference;
  both.slope.resize(both.difference.size(), a.slope.cols());
  both.slope.topRows(a.slope.rows()) = a.slope;
  both.slope.bottomRows(b.slope.rows()) = b.slope;
  return both;
}

}  // namespace plumbline::diagnose
