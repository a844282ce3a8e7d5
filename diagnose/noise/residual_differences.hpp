#pragma once
/// \file
/// Differences of neighbouring values of a residual, in which a slow gap hardly shows, and their variance.

#include <array>
#include <vector>

#include "diagnose/noise/measurement.hpp"

namespace plumbline::diagnose {

/// Names of the channels, as arrays by name have them.
constexpr std::array<Channel::Name, channel_names> all_names{
    Channel::Name::x, Channel::Name::y, Channel::Name::Fx, Channel::Name::Fy, Channel::Name::q};

/// Series that are looked at together.
using SeriesGroup = std::vector<const Series*>;

/// All series of one name, whatever their pace.
SeriesGroup series_named(const Measurements& measurements, Channel::Name name);

/// Differences of values `lag` apart.
std::vector<double> differences(const SeriesGroup& all, const std::vector<double>& residual, std::size_t lag);

/// Differences of differences of values `lag` apart.
std::vector<double> second_differences(const SeriesGroup& all, const std::vector<double>& residual,
                                       std::size_t lag);

/// Variance by Huber's proposal 2: squares are cut at (2.5 s)^2 and the mean is corrected for the cut. Nearly
/// as efficient as the plain variance, and a few percent of outliers move it by a few percent; but 16 % carry
/// it away, 0.97756 / 2.5^2.
/// \param start  to look from, where most differences are nothing and the rest is no outliers
double robust_variance(const std::vector<double>& differences, double start = 0);

/// Standard deviation of what rounding to a coarse scale does, the largest of a channel's series.
double rounding(const Measurements& measurements, Channel::Name name);

}  // namespace plumbline::diagnose
