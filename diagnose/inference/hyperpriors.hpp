#pragma once
/// \file
/// What the likelihood sums out, on grids with their priors: the size and length of the discrepancy, and the
/// scale and autocorrelation of the noise.

#include <vector>

namespace plumbline::diagnose {

struct Hyperpriors {
  /// Sizes of the discrepancy over the root mean square of the nominal residual, the first of them zero, and
  /// their prior beside a cause of the catalogue: none, or small.
  std::vector<double> amplitude, log_amplitude;
  /// The same where the cause is outside of the catalogue, and effects only imitate it.
  std::vector<double> log_amplitude_outside;
  double typical = 1;  ///< size of a cause outside of the catalogue, in the unit of the sizes

  /// The typical size that a cause outside of the catalogue has on a bench.
  void set_outside(double typical_size);
  /// Logarithm of the prior of any size over that where the cause is outside.
  [[nodiscard]] double log_odds_of_listed(double size) const;
  std::vector<double> length;  ///< over the largest command, ascending, equally probable
  std::vector<double> correlation, log_correlation;
};

/// The model of the diagnosis.
Hyperpriors full_model();
/// The same without a discrepancy.
Hyperpriors noise_alone();
/// Independent noise of one scale for each channel, and nothing else: for rough fits.
Hyperpriors white_noise_alone();

/// Logarithm of the probability that a size is within a factor of the square root of two of this one
/// (size_prior.hpp).
/// \param size  over the typical one
double log_size_prior(double size);

/// Logarithm of the prior density of the logarithm of a noise scale, but for a constant.
double log_scale_prior(double log_scale);

}  // namespace plumbline::diagnose
