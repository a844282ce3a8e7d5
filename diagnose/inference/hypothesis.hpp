#pragma once
/// \file
/// A hypothesis: effects that act together, fitted, with its evidence.

#include "diagnose/inference/likelihood.hpp"
#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

struct Hypothesis {
  Candidate candidate;
  std::vector<double> parameters;  ///< fitted coordinates
  std::vector<bool> at_bound;      ///< by parameter
  VectorXd residual;               ///< flat, declared sigmas
  MatrixXd jacobian;               ///< of the residual by the parameters
  Look look;
  double log_posterior = 0;  ///< of the parameters, up to a constant: likelihood times prior density
  double log_prior = 0;      ///< of the candidate
  double log_volume = 0;     ///< share of the prior's volume that the readings leave, by Laplace's method
  double log_evidence = 0;   ///< logarithm of prior probability times marginal likelihood
  bool converged = false;    ///< the rig can follow the experiment
  bool refined = false;      ///< maximised beside a discrepancy
};

/// How far a maximisation goes.
struct Effort {
  int iterations;
  double gain;                    ///< it ends where an iteration gains less, in log likelihood
  bool likelihood_alone = false;  ///< but for Gaussian priors: the most likely parameters
};

/// Maximises likelihood times prior density within the bounds of the parameters, from a start: Gauss and
/// Newton's steps, damped; and weighs what is found, by Laplace's method. Not converged where the rig cannot
/// follow the experiment at the start.
Hypothesis maximised(const Study& study, const Likelihood& likelihood, const Candidate& candidate,
                     const std::vector<double>& start, const Effort& effort);

/// The same from the best of several starts.
Hypothesis maximised(const Study& study, const Likelihood& likelihood, const Candidate& candidate,
                     const InitialGuesses& starts, const Effort& effort);

/// Posterior covariance of the parameters, by Laplace's method; zero rows for those at a bound.
/// \param temper  power at which the likelihood counts
MatrixXd covariance(const Study& study, const Hypothesis& hypothesis, double temper = 1);

/// Weighs the hypothesis at the parameters that it has by another likelihood.
void look_again(const Study& study, const Likelihood& likelihood, Hypothesis& hypothesis);

}  // namespace plumbline::diagnose
