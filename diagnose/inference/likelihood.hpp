#pragma once
/// \file
/// The likelihood of what a model leaves of the readings, discrepancy and noise summed out: one size of the
/// discrepancy for all channels, a scale and an autocorrelation of the noise for each (BlockLikelihood).

#include <Eigen/QR>

#include "diagnose/inference/block_likelihood.hpp"
#include "diagnose/noise/noise_estimate.hpp"

namespace plumbline::diagnose {

/// What the likelihood says of one residual.
struct Look {
  double log_likelihood = 0;  ///< beside a cause of the catalogue
  VectorXd gradient;          ///< by the parameters
  MatrixXd information;       ///< Gauss and Newton's
  /// Log likelihood at each size of the discrepancy.
  std::vector<double> log_by_amplitude;
  /// Log likelihood with a nugget in one channel, whichever: a discrepancy that no function of the command
  /// describes.
  double log_nugget = 0;
  /// Log likelihood with a discrepancy of any size in one channel, whichever, and nothing left in the others.
  double log_one_channel = 0;
  double nugget_size = 0;  ///< of that nugget, over the root mean square of the nominal residual
};

/// Posterior means of discrepancy and noise where a model leaves a residual.
struct Decomposition {
  VectorXd delta;     ///< flat, declared sigmas
  VectorXd periodic;  ///< interference, flat, declared sigmas
  NoiseEstimate noise;
};

class Likelihood {
 public:
  Likelihood(const Measurements& measurements, const CommandStates& states, const Hyperpriors& priors,
             NoiseShape shape, const VectorXd& nominal_residual);
  Likelihood(const Likelihood&) = delete;
  Likelihood& operator=(const Likelihood&) = delete;

  [[nodiscard]] const Measurements& measurements() const { return measurements_; }
  [[nodiscard]] const NoiseShape& shape() const { return shape_; }
  [[nodiscard]] const Hyperpriors& priors() const { return priors_; }

  /// \param residual  flat, declared sigmas
  /// \param jacobian  of the residual by the parameters; no columns: the likelihood alone
  [[nodiscard]] Look look(const VectorXd& residual, const MatrixXd& jacobian) const;
  [[nodiscard]] Look look(const VectorXd& residual) const {
    return look(residual, MatrixXd(residual.size(), 0));
  }
  [[nodiscard]] Decomposition decompose(const VectorXd& residual) const;

  /// Log likelihood with a discrepancy of any size, from that at each size.
  [[nodiscard]] double log_outside(const std::vector<double>& by_amplitude) const;
  /// Log likelihood where nothing but noise is beside the model until, from some reading on, an amount of its
  /// own is added to each channel or not, as probably: something slipped, broke or was moved. It lasts to the
  /// end of its run, or of the session where the runs are parts of one. Every reading but the first of a run
  /// is as probable.
  [[nodiscard]] double log_step(const VectorXd& residual) const;

  /// Leaves out correlations that are negligible where this residual is left.
  void prune(const VectorXd& residual);

 private:
  [[nodiscard]] std::vector<BlockLikelihood::Look> look_at_blocks(const VectorXd& residual,
                                                                  const MatrixXd& jacobian) const;
  /// By amplitude: log likelihood of all blocks, outliers apart.
  [[nodiscard]] std::vector<double> together(const std::vector<BlockLikelihood::Look>& blocks) const;
  void add_marked(const std::vector<BlockLikelihood::Split>& most_probable, const VectorXd& residual,
                  const MatrixXd& jacobian, Look& look) const;

  /// What the periodic columns have of values, by least squares over those that are no outliers.
  [[nodiscard]] VectorXd periodic_part(const VectorXd& values) const;

  const Measurements& measurements_;
  const CommandStates& states_;
  Hyperpriors priors_;
  NoiseShape shape_;
  double nominal_size_;  ///< root mean square of the nominal residual, declared sigmas
  Eigen::ColPivHouseholderQR<MatrixXd> periodic_;  ///< over the noise, outliers zero
  std::vector<BlockLikelihood> blocks_;
};

/// Logarithms of the posterior of the amplitudes, from likelihoods and their prior.
std::vector<double> log_posterior(const std::vector<double>& log_likelihood,
                                  const std::vector<double>& log_prior);

/// Log density of a reading that is an outlier, at a distance in standard deviations of the noise, and of one
/// that is none: with their probabilities.
double log_outlier(double distance);
double log_inlier(double distance);

}  // namespace plumbline::diagnose
