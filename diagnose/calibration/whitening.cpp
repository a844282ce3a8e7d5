#include "diagnose/calibration/whitening.hpp"

#include <Eigen/Eigenvalues>

#include "diagnose/inference/least_squares.hpp"

namespace plumbline::diagnose {

Whitening::Whitening(const Eigen::MatrixXd& unknown, const Eigen::MatrixXd& random) {
  const LeastSquares factors(unknown);
  unknown_ = unknown.cols() > 0 ? Eigen::MatrixXd(factors.orthonormal().leftCols(factors.rank()))
                                : Eigen::MatrixXd(random.rows(), 0);
  const Eigen::MatrixXd left = random - unknown_ * (unknown_.transpose() * random);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd(left.transpose() * left));
  std::vector<Eigen::Index> axes;
  for (Eigen::Index i = 0; i < left.cols(); ++i)
    if (constexpr double negligible = 1e-6; eigen.eigenvalues()(i) > negligible) axes.push_back(i);
  const Eigen::VectorXd variance = eigen.eigenvalues()(axes);
  random_ = left * eigen.eigenvectors()(Eigen::all, axes) * variance.cwiseSqrt().cwiseInverse().asDiagonal();
  taken_ = 1 - (1 + variance.array()).rsqrt();
}

Eigen::VectorXd Whitening::operator()(Eigen::VectorXd values) const {
  if (unknown_.cols() > 0) values -= unknown_ * (unknown_.transpose() * values);
  if (random_.cols() > 0) values -= random_ * taken_.cwiseProduct(random_.transpose() * values);
  return values;
}

}  // namespace plumbline::diagnose
