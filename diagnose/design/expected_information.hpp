#pragma once
/// \file
/// What a run is expected to tell of which explanation is right.

#include <Eigen/Core>
#include <vector>

namespace plumbline::diagnose {

/// What an explanation predicts of a run, in standard deviations of its readings.
struct Forecast {
  Eigen::VectorXd read;
  Eigen::MatrixXd slope;       ///< derivatives by the explanation's parameters
  Eigen::MatrixXd covariance;  ///< of the parameters, as far as they are known before the run
};

/// Nats by which the run is expected to lower the entropy of the choice among explanations that were equally
/// probable: at least so many, at most the logarithm of their number. What an explanation predicts is
/// Gaussian, of the noise and of the spread of its parameters; the bound is that of Kolchinsky and Tracey
/// (Entropy 19, 361, 2017) with Bhattacharyya's distance. \param hypotheses  one explanation or more
double expected_information(const std::vector<Forecast>& hypotheses);

}  // namespace plumbline::diagnose
