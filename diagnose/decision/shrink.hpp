#pragma once
/// \file
/// How far a gap shrinks, on readings that no choice and no fit has seen.

#include <map>

#include "diagnose/decision/heldout.hpp"
#include "diagnose/beliefs.hpp"
#include "diagnose/inference/fit.hpp"

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
  std::size_t left_out = 0;        ///< values there that stand off their neighbours: in none of these figures
  double ratio_with_left_out = 1;  ///< what the ratio is with them
  double independent = 0;          ///< so many values that do not correlate would scatter as its mean does
  std::map<Channel, ChannelShrink> channels;
  /// Whether a choice that sees no more than the fits falls on what shrinks it, or on what is not told apart.
  bool chosen_blind = false;

  /// Whether the readings carry a gap that could shrink.
  [[nodiscard]] bool tested() const { return noise_floor_ratio <= beliefs::carries_no_gap; }
  /// Share of the gap that is left beyond the noise.
  [[nodiscard]] double beyond_noise() const;
};

/// Compares residuals before (nominal) and after on the held-out readings; outliers are left out of both,
/// and counted. Bounds by resampling blocks of neighbouring readings.
Shrink measure_shrink(const Measurements& measurements, const HeldOut& heldout,
                      const std::vector<double>& before, const std::vector<double>& after,
                      const NoiseModel& noise);

}  // namespace plumbline::diagnose
