#pragma once
/// \file
/// A hypothesis: rows that act together, fitted, with its evidence.

#include "diagnose/inference/hypothesis.hpp"
#include "diagnose/motion/likelihood.hpp"

namespace plumbline::motion {

struct Hypothesis {
  Candidate candidate;
  std::vector<Parameter> parameters;
  std::vector<double> values;
  std::vector<bool> at_bound;
  std::vector<Begin> begins;
  Eigen::MatrixXd covariance;  ///< of the parameters; zero rows for those at a bound
  Look look;
  double log_prior = 0;   ///< of the candidate
  bool shows = true;      ///< the logs would show one of the rows' parameters at its typical size
  double log_volume = 0;  ///< share of the prior's volume that the readings leave to the rows' parameters
  [[nodiscard]] double log_evidence() const { return log_prior + log_volume + look.log_likelihood; }
};

/// Where a fit begins.
struct Start {
  std::vector<double> values;
  std::vector<Begin> begins;
};

/// The most probable parameters from a start, by Gauss and Newton's damped steps within their bounds, and the
/// evidence by Laplace's method. The unknown numbers of the drive are the same in every hypothesis and have a
/// flat prior.
Hypothesis fitted(const Study& study, const Likelihood& likelihood, Candidate candidate, Start start);

/// What a fit from this start promises: the log likelihood at the end of one step of Newton's, in one cell;
/// of many segments, some suffice.
double forecast(const Study& study, const Likelihood& likelihood, const Candidate& candidate,
                const Start& start, const Cell& cell);

/// Root mean square of what a hypothesis leaves of the means, by quantity; 0 where none is read.
Quantities sizes_of(const std::vector<SegmentMeans>& left);

}  // namespace plumbline::motion
