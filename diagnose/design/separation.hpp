#pragma once
/// \file The separation of two hypotheses: the part of one prediction that the other, refitted, cannot
/// reproduce.

#include <cmath>

#include "diagnose/inference/hypothesis.hpp"
#include "diagnose/noise/noise_estimate.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {

/// Two hypotheses are distinguished by an expected log-likelihood ratio above this: the worse one is then,
/// were both equally probable before, not worth naming beside the better one.
inline const double told_apart = std::log(priors::wrong_over_further_name);
/// Below this their readings are the same, to rounding and the tolerance of fits.
inline constexpr double same_readings = 1e-3;

/// A linearised alternative: the difference of two predictions in standard deviations, and the derivatives of
/// the alternative by its parameters, zero of those that cannot move.
struct LinearisedAlternative {
  Eigen::VectorXd difference;
  Eigen::MatrixXd slope;
};

/// Derivatives of what a hypothesis leaves, in declared sigmas; zero by parameters at a bound, which cannot
/// move on.
MatrixXd free_jacobian(const Hypothesis& hypothesis);

/// For two hypotheses fitted to the same readings.
LinearisedAlternative linearised_alternative(const Measurements& measurements, const NoiseEstimate& noise,
                                             const Hypothesis& truth, const Hypothesis& alternative);

/// Squared distance after the alternative is refitted. If `truth` is true, its expected log-likelihood ratio
/// is half of it, averaged over the noise.
double separation(const LinearisedAlternative& rows);

/// The same with as few rows as possible, by a triangular factor.
LinearisedAlternative reduced(const LinearisedAlternative& rows);

/// The rows of both, with common parameters.
LinearisedAlternative stacked(const LinearisedAlternative& a, const LinearisedAlternative& b);

}  // namespace plumbline::diagnose
