#pragma once
/// \file
/// The noise of the readings as it is, beside what was declared: scale, correlation in time, outliers.

#include <array>
#include <vector>

#include "diagnose/model/measurement.hpp"

namespace plumbline::diagnose {

/// What labs do to a declared sigma, and how long readings remember each other. These are the priors on
/// noise: a declared sigma is wrong by a factor of 1.5 at most, and neighbouring readings correlate by 0.7 at
/// most.
inline constexpr double largest_scale = 1.5;
inline constexpr double largest_correlation = 0.7;

/// First-order autoregressive noise: true sigma = scale · declared sigma, correlation between neighbours.
struct NoiseModel {
  std::array<double, 3> scale{1.0, 1.0, 1.0};  ///< by Sensor
  double correlation = 0.0;

  [[nodiscard]] double of(Sensor sensor) const { return scale[static_cast<std::size_t>(sensor)]; }
};

/// What the differences of neighbouring residuals say, before any prior or limit.
struct RawNoise {
  std::array<double, 3> scale{1.0, 1.0, 1.0};
  std::array<double, 3> values{0.0, 0.0, 0.0};  ///< number of differences behind each scale
  double correlation = 0.0;
};

/// Marks isolated readings that stand off both their neighbours (Hampel's identifier, five readings wide).
/// \param residual  flat, in declared sigmas
std::vector<bool> outliers(const Measurements& measurements, const std::vector<double>& residual);

/// The residual with each outlier replaced by the median of its neighbourhood.
std::vector<double> without_outliers(const Measurements& measurements, const std::vector<double>& residual);

/// Scale and correlation from first and second-neighbour differences of a residual free of outliers, so that
/// a slowly varying gap does not enter: E(e_t - e_{t-m})^2 = 2 sigma^2 (1 - phi^m).
RawNoise raw_noise(const Measurements& measurements, const std::vector<double>& residual);

/// The same with the priors: a log-normal scale and a half-normal correlation, both within their limits.
NoiseModel estimate_noise(const Measurements& measurements, const std::vector<double>& residual);

/// Standardised innovations: independent and of unit variance when the residual is this noise.
std::vector<double> whiten(const Measurements& measurements, const std::vector<double>& residual,
                           const NoiseModel& noise);

}  // namespace plumbline::diagnose
