#pragma once
/// \file
/// The likelihood of what a model leaves of the readings, discrepancy and noise summed out: one size of the
/// discrepancy for all channels, a scale and an autocorrelation of the noise for each (BlockLikelihood).

#include <Eigen/QR>
#include <memory>

#include "diagnose/inference/block_likelihood.hpp"
#include "diagnose/noise/noise_estimate.hpp"

namespace plumbline::diagnose {

/// What it says of one channel, outliers apart.
struct ChannelLook {
  std::vector<double> log_by_amplitude;
  VectorXd log_by_scale;            ///< by the scale of the noise, with noise alone
  std::vector<double> discrepancy;  ///< as of Look
};

/// What the likelihood says of one residual.
struct Look {
  double log_likelihood = 0;  ///< beside a cause of the catalogue
  VectorXd gradient;          ///< by the parameters
  MatrixXd information;       ///< Gauss and Newton's
  /// Log likelihood at each size of the discrepancy.
  std::vector<double> log_by_amplitude;
  /// At each size of the discrepancy: its variance over that of the noise, one at most; the mean of all
  /// values.
  std::vector<double> discrepancy;
  std::vector<ChannelLook> channels;
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
  [[nodiscard]] const CommandStates& states() const { return states_; }
  [[nodiscard]] const std::vector<BlockLikelihood>& blocks() const { return blocks_; }
  /// Root mean square of the nominal residual, declared sigmas.
  [[nodiscard]] double nominal_size() const { return nominal_size_; }
  /// What a cause outside of the catalogue typically changes in the readings of a block, declared sigmas.
  [[nodiscard]] double typical_size(std::size_t block) const { return typical_[block]; }
  /// The same of noise alone, with every autocorrelation.
  [[nodiscard]] std::unique_ptr<Likelihood> of_noise_alone() const;

  /// \param residual  flat, declared sigmas
  /// \param jacobian  of the residual by the parameters; no columns: the likelihood alone
  [[nodiscard]] Look look(const VectorXd& residual, const MatrixXd& jacobian) const;
  [[nodiscard]] Look look(const VectorXd& residual) const {
    return look(residual, MatrixXd(residual.size(), 0));
  }
  [[nodiscard]] Decomposition decompose(const VectorXd& residual) const;

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
  VectorXd nominal_residual_;
  double nominal_size_;
  std::vector<double> typical_;                    ///< by block
  Eigen::ColPivHouseholderQR<MatrixXd> periodic_;  ///< over the noise, outliers zero
  std::vector<BlockLikelihood> blocks_;
};

/// Logarithms of the posterior of the amplitudes, from likelihoods and their prior.
std::vector<double> log_posterior(const std::vector<double>& log_likelihood,
                                  const std::vector<double>& log_prior);

/// Posterior mean of what is known at each amplitude.
double expected(const std::vector<double>& log_likelihood, const std::vector<double>& log_prior,
                const std::vector<double>& values);

}  // namespace plumbline::diagnose
