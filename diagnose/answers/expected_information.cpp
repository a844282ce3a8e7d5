#include "diagnose/answers/expected_information.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace plumbline::diagnose {
namespace {

/// A Gaussian prediction.
struct Gaussian {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};

/// The predictions, in coordinates of the plane in which they differ in anything.
std::vector<Gaussian> predictions(const std::vector<Forecast>& rivals) {
  const Forecast& first = rivals.front();
  Eigen::Index columns = static_cast<Eigen::Index>(rivals.size());
  for (const Forecast& one : rivals) columns += one.slope.cols();
  Eigen::MatrixXd all(first.read.size(), columns);
  Eigen::Index next = 0;
  for (const Forecast& one : rivals) {
    all.col(next) = one.read - first.read;
    all.middleCols(next + 1, one.slope.cols()) = one.slope;
    next += 1 + one.slope.cols();
  }
  const Eigen::Index kept = std::min(all.rows(), all.cols());
  const Eigen::MatrixXd factor =
      Eigen::HouseholderQR<Eigen::MatrixXd>(all).matrixQR().topRows(kept).triangularView<Eigen::Upper>();
  std::vector<Gaussian> result;
  next = 0;
  for (const Forecast& one : rivals) {
    const Eigen::MatrixXd slope = factor.middleCols(next + 1, one.slope.cols());
    result.push_back({factor.col(next),
                      Eigen::MatrixXd::Identity(kept, kept) + slope * one.covariance * slope.transpose()});
    next += 1 + one.slope.cols();
  }
  return result;
}

double log_determinant(const Eigen::LLT<Eigen::MatrixXd>& factor) {
  return 2 * Eigen::MatrixXd(factor.matrixL()).diagonal().array().log().sum();
}

/// Bhattacharyya's distance.
double distance(const Gaussian& a, const Gaussian& b) {
  const Eigen::LLT<Eigen::MatrixXd> between((a.covariance + b.covariance) / 2);
  const Eigen::VectorXd apart = a.mean - b.mean;
  return apart.dot(between.solve(apart)) / 8 +
         (log_determinant(between) -
          (log_determinant(a.covariance.llt()) + log_determinant(b.covariance.llt())) / 2) /
             2;
}

}  // namespace

double expected_information(const std::vector<Forecast>& rivals) {
  const std::vector<Gaussian> all = predictions(rivals);
  const std::size_t count = all.size();
  Eigen::MatrixXd overlap =
      Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
      overlap(i, j) = overlap(j, i) = std::exp(-distance(all[a], all[b]));
    }
  return -(overlap.rowwise().mean().array().log().mean());
}

}  // namespace plumbline::diagnose
