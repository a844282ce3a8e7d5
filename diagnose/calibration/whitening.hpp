#pragma once
/// \file
/// What values leave where frames are unknown and every joint is a little off.

#include <Eigen/Core>

namespace plumbline::diagnose {

/// The symmetric root W of the inverse covariance of values r = F f + Z z + noise, over that of the noise,
/// with nothing known of f and z ~ N(0, 1): W = (1 - P)(1 + Z Z')^{-1/2}, where P projects on F and Z is what
/// F leaves of it. W r has the likelihood of r, f and z summed out.
class Whitening {
 public:
  /// Of noise alone: values stay as they are.
  Whitening() = default;
  /// \param unknown  F, independent or not
  /// \param random   Z: columns times their standard deviations, over that of the noise
  Whitening(const Eigen::MatrixXd& unknown, const Eigen::MatrixXd& random);

  [[nodiscard]] Eigen::VectorXd operator()(Eigen::VectorXd values) const;

 private:
  Eigen::MatrixXd unknown_, random_;  ///< orthonormal
  Eigen::VectorXd taken_;             ///< share of each random axis that is taken away
};

}  // namespace plumbline::diagnose
