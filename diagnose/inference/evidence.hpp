#pragma once
/// \file
/// How much an explanation is worth: its likelihood under the noise as it is, and its evidence, which charges
/// it for its freedom.

#include "diagnose/inference/fit.hpp"
#include "diagnose/noise/noise.hpp"

namespace plumbline::diagnose {

/// Logarithm of the density of a residual. Its innovations are normal; two in a hundred may be outliers, ten
/// times as wide.
double log_likelihood(const Measurements& measurements, const std::vector<double>& residual,
                      const NoiseModel& noise);

/// Logarithm of the prior probability that these effects act at these places, before any reading: a gap has
/// one cause in three of four experiments, two in one of five, three in the rest; every effect is as likely
/// as every other, but rarer where a plainer one is a special case of it, and equally likely at each of its
/// places.
double log_prior(const Study& study, const Candidate& candidate);

/// Covariance of the parameters at a fit, as far as they are open: what the readings do not tell keeps the
/// width of the prior. Zero rows for those at a bound.
Eigen::MatrixXd posterior_covariance(const Study& study, const Fit& fit);

/// Logarithm of the evidence, by Laplace's method at the fit: likelihood, times the prior density of the
/// fitted parameters, times the volume that the readings leave them. The prior of a parameter is a Cauchy
/// density whose width is what a lab would call a sizeable effect, on the side of zero that is physical; of a
/// position along an axis that has no natural zero (a stop's angle, a time constant) it is uniform over its
/// range.
double log_evidence(const Study& study, const Fit& fit, const NoiseModel& noise);

/// What the priors of tolerances charge the values that they hold: the sum of their squares, in tolerances.
double tolerance_charge(const Study& study, const Fit& fit);

}  // namespace plumbline::diagnose
