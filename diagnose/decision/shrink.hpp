#pragma once
/// \file
/// How far a gap shrinks, on readings that the fit has not seen.

#include <map>

#include "diagnose/decision/heldout.hpp"
#include "diagnose/noise/noise_estimate.hpp"

namespace plumbline::diagnose {

/// The same for one channel alone.
struct ChannelShrink {
  double ratio = 1, ratio_low = 1, ratio_high = 1, noise_floor_ratio = 1;
};

struct Shrink {
  std::vector<std::string> heldout;
  std::map<Channel, double> rms_before, rms_after;  ///< by channel, in its unit
  double ratio = 1, ratio_low = 1, ratio_high = 1;  ///< noise-weighted rms after / before; 95 % bounds
  double noise_floor_ratio = 1;                     ///< what a perfect model would reach
  double chi2_per_value_after = 1;                  ///< every value in the noise of its channel
  std::size_t outliers = 0;        ///< values there that are outliers: in none of these figures
  double ratio_with_outliers = 1;  ///< what the ratio is with them
  std::map<Channel, ChannelShrink> channels;

  /// Whether the readings carry a gap that could shrink: more than the noise, by its squares.
  [[nodiscard]] bool tested() const { return 2 * noise_floor_ratio * noise_floor_ratio <= 1; }
  /// Whether the model surely predicts no better than the nominal one.
  [[nodiscard]] bool fails() const { return ratio_low > 1; }
};

/// Compares residuals before (nominal) and after on the held-out readings; outliers are left out of both,
/// and counted. Bounds by resampling blocks of neighbouring readings.
/// \param before, after  flat, declared sigmas
Shrink measure_shrink(const Measurements& measurements, const HeldOut& heldout, const VectorXd& before,
                      const VectorXd& after, const NoiseEstimate& noise);

}  // namespace plumbline::diagnose
