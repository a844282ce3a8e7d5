#pragma once
/// \file
/// How far a gap shrinks, on readings that no choice and no fit has seen.

#include <map>

#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// The readings that are set aside before anything is fitted.
struct HeldOut {
  std::vector<std::vector<bool>> reading;  ///< [run][reading]
  std::vector<std::string> names;          ///< of runs, or of blocks as "run[from:to]"

  [[nodiscard]] bool empty() const { return names.empty(); }
};

/// What to set aside: of the kind of runs (control, loading only or not) that there are most of, the one that
/// goes farthest but one, where there are two and three runs in all; else two blocks of the path of every
/// run. Decided by what was commanded, before any residual is looked at. Nothing where too little would be
/// left.
HeldOut choose_heldout(const Experiment& experiment);

/// Two blocks of the path of every run.
HeldOut choose_blocks(const Experiment& experiment);

/// The experiment without the measured values that are held out; what was commanded stays, for the history.
Experiment without(const Experiment& experiment, const HeldOut& heldout);

/// The same for one channel alone.
struct ChannelShrink {
  double ratio = 1, ratio_low = 1, ratio_high = 1, noise_floor_ratio = 1;
};

struct Shrink {
  std::vector<std::string> heldout;
  std::map<Channel, double> rms_before, rms_after;  ///< by channel, in its unit
  double ratio = 1, ratio_low = 1, ratio_high = 1;  ///< noise-weighted rms after / before; 95 % bounds
  double noise_floor_ratio = 1;                     ///< what a perfect model would reach
  double chi2_per_value_after = 1;
  std::map<Channel, ChannelShrink> channels;
};

/// Compares residuals before (nominal) and after on the held-out readings; isolated outliers are left out of
/// both. Bounds by resampling blocks of neighbouring readings.
Shrink measure_shrink(const Measurements& measurements, const HeldOut& heldout,
                      const std::vector<double>& before, const std::vector<double>& after,
                      const NoiseModel& noise);

}  // namespace plumbline::diagnose
