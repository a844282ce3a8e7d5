#pragma once
/// \file
/// Fitting a candidate's parameters to an experiment: robust weighted least squares within physical bounds.

#include <Eigen/Core>
#include <vector>

#include "diagnose/inference/start.hpp"
#include "diagnose/inference/study.hpp"
#include "diagnose/noise/measurement.hpp"
#include "diagnose/noise/noise.hpp"

namespace plumbline::diagnose {

/// What a fit weighs.
struct FitSettings {
  NoiseModel noise;  ///< residuals are whitened by it
  /// Huber's bound, in standard deviations: a residual beyond it counts by its size, no longer by its square.
  double outlier_bound = 3;
};

/// A fitted candidate.
struct Fit {
  Candidate candidate;
  NoiseModel noise;                ///< by which all of it is whitened
  std::vector<double> parameters;  ///< fitted coordinates
  std::vector<bool> at_bound;      ///< by parameter
  /// Of the parameters, given the readings and the priors of tolerances; zero rows for those at a bound.
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd jacobian;  ///< of the whitened residual
  /// Information that the values hold on the parameters, J^T J in whitened units, without outliers. A zero on
  /// the diagonal: the runs never exercised it.
  Eigen::MatrixXd information;
  /// Twice the loss: the chi-square, but for outliers, and what the priors of tolerances charge.
  double cost = 0;
  std::vector<double> residual;  ///< (measured - predicted) / declared sigma, flat, all values
  std::vector<double> whitened;  ///< the same, whitened
  bool converged = false;        ///< a minimum was found, at which the rig can follow the experiment
};

/// Fits from the given start; or from those of several where least is left, or of those that `starts()`
/// names, and returns the best.
Fit fit(const Study& study, const Candidate& candidate, const FitSettings& settings);
Fit fit(const Study& study, const Candidate& candidate, const FitSettings& settings,
        const InitialGuesses& known);
Fit fit_from(const Study& study, const Candidate& candidate, const FitSettings& settings,
             const std::vector<double>& start);

/// The same parameters, and what is known of them in another noise.
Fit in_noise(const Study& study, const Fit& fitted, const NoiseModel& noise);

/// Bounds of one parameter by profile likelihood: where the cost, minimised over all others, has risen by
/// `rise` (3.84 for 95 %). A bound that the physical range cuts off is that end of the range.
/// In catalogue units, low < high.
struct Profile {
  double low, high;
};
Profile profile(const Study& study, const Fit& fitted, std::size_t parameter, const FitSettings& settings,
                double rise);

/// Huber's loss of one whitened residual, twice: its square up to the bound, then linear.
double huber(double residual, double bound);

/// Degrees of freedom that a fit leaves to the readings, one at least: a parameter that its tolerance holds
/// takes as much of one as the readings tell of it, one at a bound none.
double degrees_of_freedom(const Measurements& measurements, const Fit& fit);

/// Chi-square per degree of freedom that a fit leaves in this noise, without outliers.
double chi2_per_dof(const Measurements& measurements, const Fit& fit, const NoiseModel& noise);

}  // namespace plumbline::diagnose
