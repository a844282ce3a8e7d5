#pragma once
/// \file
/// What is said of the noise of the readings: scale, correlation, and how they are looked at.

#include <array>

#include "diagnose/noise/series.hpp"

namespace plumbline::diagnose {

/// A number for each kind of sensor.
using BySensor = std::array<double, sensors>;

inline double of(const Channel& channel, const BySensor& all) {
  return all[place_of(channel.sensor())];
}

/// How the noise of each kind of sensor is looked at.
struct Manner {
  /// It is forgotten with time, as by a filter, and not with every reading.
  std::array<bool, sensors> with_time{};
  /// By second differences, to which a slope of the gap adds nothing.
  std::array<bool, sensors> by_bends{};

  bool operator==(const Manner& other) const = default;
};

/// Correlation of neighbours in a series, from those of every sensor where it is read fastest.
double at_pace(const Series& series, const BySensor& correlation, const Manner& manner);

/// First-order autoregressive noise: true sigma = scale · declared sigma, correlation between neighbours.
struct NoiseModel {
  std::array<double, channel_names> scale{1.0, 1.0, 1.0, 1.0, 1.0};  ///< by Channel::Name
  /// Where it is read fastest: a filter that is in a load cell is not in a camera.
  BySensor correlation{};
  Manner manner{};

  bool operator==(const NoiseModel& other) const = default;

  [[nodiscard]] double of(const Channel& channel) const {
    return scale[static_cast<std::size_t>(channel.name)];
  }
  [[nodiscard]] double correlation_of(const Channel& channel) const {
    return diagnose::of(channel, correlation);
  }
  [[nodiscard]] double correlation_of(const Series& series) const {
    return at_pace(series, correlation, manner);
  }
};

}  // namespace plumbline::diagnose
