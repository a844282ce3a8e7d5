#pragma once
/// \file
/// What readings leave where frames are unknown and every joint is a little off.

#include <Eigen/Core>

namespace plumbline::diagnose {

class Study;

/// The symmetric root W of the inverse covariance of values r = F f + Z z + noise, over that of the noise,
/// with nothing known of f and z ~ N(0, 1): W = (1 - P)(1 + Z Z')^{-1/2}, where P projects on F and Z is what
/// F leaves of it. W r has the likelihood of r with f and z summed out, but for a constant.
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

/// The frames and the tolerances of a study's calibration, summed out of its readings.
class SummedOut {
 public:
  /// Nothing is unknown: values stay as they are.
  SummedOut() = default;
  explicit SummedOut(const Study& study);

  /// Of what the nominal arm leaves, whose tolerances stand at their posterior mean; of what it leaves
  /// without them, to first order.
  [[nodiscard]] Eigen::VectorXd of_residual(const Eigen::VectorXd& residual) const;
  /// Of a derivative; zero where frames and tolerances hold all of it.
  [[nodiscard]] Eigen::VectorXd of_slope(const Eigen::VectorXd& slope) const;

 private:
  Whitening whitening_;
  Eigen::VectorXd without_;  ///< what the tolerances' mean adds to the readings; empty: nothing
};

/// Derivatives of all readings, in declared sigmas, by the shift and the turn of the tracker, of each point
/// on its link, of each sensor in its own axes, then by the logarithm of each focal length; zero for what no
/// reading shows, and no columns where frames are known.
Eigen::MatrixXd frame_columns(const Study& study);

}  // namespace plumbline::diagnose
