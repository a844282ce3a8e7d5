#pragma once
/// \file
/// The noise of the readings as it is, beside what was declared: scale, correlation in time, outliers.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "diagnose/model/measurement.hpp"

namespace plumbline::diagnose {

/// A number for each kind of sensor.
using BySensor = std::array<double, sensors>;

inline double of(const Channel& channel, const BySensor& all) {
  return all[static_cast<std::size_t>(channel.sensor())];
}

/// Of each kind of sensor, whether its noise is forgotten with time, as by a filter, and not with every
/// reading.
using ForgetsWithTime = std::array<bool, sensors>;

/// Correlation of neighbours in a series, from those of every sensor where it is read fastest.
double at_pace(const Series& series, const BySensor& correlation, const ForgetsWithTime& with_time);

/// First-order autoregressive noise: true sigma = scale · declared sigma, correlation between neighbours.
struct NoiseModel {
  std::array<double, channel_names> scale{1.0, 1.0, 1.0, 1.0, 1.0};  ///< by Channel::Name
  /// Where it is read fastest: a filter that is in a load cell is not in a camera.
  BySensor correlation{};
  ForgetsWithTime with_time{};

  bool operator==(const NoiseModel& other) const = default;

  [[nodiscard]] double of(const Channel& channel) const {
    return scale[static_cast<std::size_t>(channel.name)];
  }
  [[nodiscard]] double correlation_of(const Channel& channel) const {
    return diagnose::of(channel, correlation);
  }
  [[nodiscard]] double correlation_of(const Series& series) const {
    return at_pace(series, correlation, with_time);
  }
};

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

/// Marks readings that stand off their neighbours, alone or in twos (Hampel's identifier, nine readings
/// wide, five where a series is short).
/// \param residual  flat, in declared sigmas
std::vector<bool> outliers(const Measurements& measurements, const std::vector<double>& residual);

/// The residual with each outlier replaced by the median of its neighbourhood.
std::vector<double> without_outliers(const Measurements& measurements, const std::vector<double>& residual);

/// Scale and correlation from differences of a residual free of outliers, so that a slowly varying gap does
/// not enter: E(e_t - e_{t-m})^2 = 2 sigma^2 (1 - phi^m). Where first differences grow with their distance as
/// no such noise does, a gap with a slope is in them, and the scale is that of second differences,
/// E(e_{t-1} - 2 e_t + e_{t+1})^2 = 2 sigma^2 (1 - phi)(3 - phi).
RawNoise raw_noise(const Measurements& measurements, const std::vector<double>& residual);

/// Which sensors' noise is forgotten with time: where runs are read at different paces, what their
/// differences say of neighbours agrees better so than with one correlation for all.
ForgetsWithTime forgets_with_time(const Measurements& measurements, const std::vector<double>& residual);

/// Standard deviation of a correlation as so many values tell it: 1.4 over their root in simulated noise that
/// does not correlate, 1.8 in noise that does by a half, 2.1 by 0.9.
double correlation_deviation(double correlation, double values);

/// The same with the priors: a scale near one unless the readings say otherwise, and a half-normal
/// correlation.
NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual);

/// The same of noise of which it is known how it is forgotten.
NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual,
                          const ForgetsWithTime& with_time);

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
