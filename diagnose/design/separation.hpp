#pragma once
/// \file
/// The separation of two hypotheses: the part of one prediction that the other, refitted, cannot imitate.

#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// A linearised alternative: the difference of two predictions in standard deviations, and the derivatives of
/// the alternative by its parameters.
struct LinearisedAlternative {
  Eigen::VectorXd difference;
  Eigen::MatrixXd slope;
};

/// For two fits to the same readings, in the same noise.
LinearisedAlternative linearised_alternative(const Fit& truth, const Fit& alternative);

/// Squared distance after the alternative is refitted. If `truth` is true, its expected log-likelihood ratio
/// is half of it, averaged over the noise.
double separation(const LinearisedAlternative& rows);

/// The same with as few rows as possible, by a triangular factor.
LinearisedAlternative reduced(const LinearisedAlternative& rows);

/// The rows of both, with common parameters.
LinearisedAlternative stacked(const LinearisedAlternative& a, const LinearisedAlternative& b);

}  // namespace plumbline::diagnose
