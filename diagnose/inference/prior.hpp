#pragma once
/// \file
/// Prior probabilities of hypotheses, and prior densities of their parameters.

#include <Eigen/Core>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Logarithm of the prior probability that these effects act at these places.
double log_prior(const Study& study, const Candidate& candidate);

/// The prior density of one parameter: Gaussian about zero where it has a tolerance; Cauchy about zero, on
/// the side that is physical, where zero is the nominal model or the parameter is a threshold; else uniform
/// over its range.
class ParameterPrior {
 public:
  explicit ParameterPrior(const ParameterRange& range);
  [[nodiscard]] double log_density(double value) const;
  /// Curvature of a quadratic that touches -log_density at the value and lies above it elsewhere: the
  /// gradient of -log_density is `curvature * value`.
  [[nodiscard]] double curvature(double value) const;
  /// Standard deviation of the Gaussian that is as high.
  [[nodiscard]] double width() const;

 private:
  enum class Shape { gaussian, cauchy, uniform } shape_;
  double scale_, largest_;
};

/// Whether there are three readings for each parameter, and sixty parameters at most. Those with Gaussian
/// priors count as one.
bool affordable(const Study& study, const Candidate& candidate);

/// Probability, given a cause of the catalogue, of a single one that takes more readings than there are.
double untested_share(const Study& study);

}  // namespace plumbline::diagnose
