#include "diagnose/design/separation.hpp"

#include <Eigen/Core>

#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {

MatrixXd free_jacobian(const Hypothesis& hypothesis) {
  MatrixXd jacobian = hypothesis.jacobian;
  for (std::size_t p = 0; p < hypothesis.at_bound.size(); ++p)
    if (hypothesis.at_bound[p]) jacobian.col(static_cast<Eigen::Index>(p)).setZero();
  return jacobian;
}

LinearisedAlternative linearised_alternative(const Measurements& measurements, const NoiseEstimate& noise,
                                             const Hypothesis& truth, const Hypothesis& alternative) {
  return {noise.whitened(measurements, alternative.residual - truth.residual),
          noise.whitened(measurements, free_jacobian(alternative))};
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
