#pragma once
/// \file
/// How far apart two explanations are: what one predicts and the other, refitted, cannot imitate.

#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// Rows of a linear imitation: what one explanation predicts beyond another, in standard deviations, and what
/// the parameters of the other can do about it.
struct LinearisedAlternative {
  Eigen::VectorXd difference;
  Eigen::MatrixXd slope;
};

/// On the readings that both were fitted to, in the same noise.
LinearisedAlternative linearised_alternative(const Fit& truth, const Fit& alternative);

/// Squared distance that is left when the alternative has done its best. If `truth` is true, its
/// log-likelihood is expected to lead by half of this, whatever the noise of this experiment happens to
/// favour.
double separation(const LinearisedAlternative& rows);

/// The same in as many rows as matter, by its triangular factor.
LinearisedAlternative reduced(const LinearisedAlternative& rows);

/// Both sets of rows under the same parameters.
LinearisedAlternative stacked(const LinearisedAlternative& a, const LinearisedAlternative& b);

}  // namespace plumbline::diagnose
