#pragma once
/// \file
/// The expected information of a run about which hypothesis is true.

#include <Eigen/Core>
#include <vector>

namespace plumbline::diagnose {

/// The prediction of a run by one hypothesis, in standard deviations of its readings.
struct Forecast {
  Eigen::VectorXd read;
  Eigen::MatrixXd slope;       ///< derivatives by the parameters
  Eigen::MatrixXd covariance;  ///< of the parameters before the run
};

/// A lower bound, in nats, on the expected decrease of the entropy of the choice among equally probable
/// hypotheses: that of Kolchinsky and Tracey (Entropy 19, 361, 2017) with Bhattacharyya's distance, for
/// Gaussian predictions with the covariance of noise and parameters. The largest value is the logarithm of
/// the number of hypotheses.
/// \param hypotheses  at least one
double expected_information(const std::vector<Forecast>& hypotheses);

}  // namespace plumbline::diagnose
