#pragma once
/// \file
/// The noise of the readings as it is, beside what was declared: scale, and correlation in time.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "diagnose/noise/noise_model.hpp"
#include "diagnose/noise/measurement.hpp"

namespace plumbline::diagnose {

/// What the differences of neighbouring residuals say, before any prior or limit.
struct RawNoise {
  std::array<double, channel_names> scale{1.0, 1.0, 1.0, 1.0, 1.0};
  std::array<double, channel_names> values{};  ///< number of differences behind each scale
  /// What no scale exceeds, for values read close to each other on the path scatter no more; infinite where
  /// few were.
  std::array<double, channel_names> largest_in_place{};
  BySensor correlation{};
  /// What neighbours can correlate at most: noise that remembers longer than a tenth of a run cannot be told
  /// from a gap, unless it is no larger than what was declared.
  BySensor largest_correlation{};
};

/// Scale and correlation from differences of a residual free of outliers, so that a slowly varying gap does
/// not enter: E(e_t - e_{t-m})^2 = 2 sigma^2 (1 - phi^m). Where first differences grow with their distance as
/// no such noise does, a gap with a slope is in them, and the scale is that of second differences,
/// E(e_{t-1} - 2 e_t + e_{t+1})^2 = 2 sigma^2 (1 - phi)(3 - phi).
RawNoise raw_noise(const Measurements& measurements, const std::vector<double>& residual);

/// The same with the priors: a scale near one unless the readings say otherwise, and a half-normal
/// correlation.
NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual);

/// The same of readings that are looked at in this manner.
NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual,
                          const Manner& manner);

/// By how much neighbours may correlate more than is estimated, at the upper places of five (Gauss and
/// Hermite's): the rest is the estimate's, for the lower places, where noise is less slow, count as that. All
/// sensors stand at the same place: any of them may be slower.
struct PossibleCorrelation {
  BySensor value;
  double probability;
};
std::array<PossibleCorrelation, 2> larger_correlations(const Measurements& measurements,
                                                       const std::vector<double>& residual,
                                                       const NoiseModel& estimated);

/// Standardised innovations of values in the order of reading, whose noise has this scale and correlates so
/// from one to the next.
Eigen::VectorXd whitened(const Eigen::Ref<const Eigen::VectorXd>& values, double scale, double correlation);

/// Standardised innovations: independent and of unit variance when the residual is this noise.
std::vector<double> whiten(const Measurements& measurements, const std::vector<double>& residual,
                           const NoiseModel& noise);

}  // namespace plumbline::diagnose
