#pragma once
/// \file
/// What differences of a residual say of its noise, channel by channel.

#include <cmath>
#include <vector>

#include "diagnose/noise/noise_model.hpp"
#include "diagnose/noise/residual_differences.hpp"

namespace plumbline::diagnose {

/// Standard deviation of a correlation as so many values tell it: 1.4 over their root in simulated noise that
/// does not correlate, 1.8 in noise that does by a half, 2.1 by 0.9.
double correlation_deviation(double correlation, double values);

/// Variance of the noise of a channel, read at one pace, times 1 - phi, as first differences show it, and how
/// much larger differences over two readings are, 1 + phi; without the variance that rounding adds, which
/// does not correlate.
struct Steps {
  std::size_t name = 0;
  double pace = 1;
  double near = 0, ratio = 1, values = 0, rounded = 0;
  /// The same as second differences show it, to which a slope adds nothing.
  double curved = 0, curved_correlation = 0;

  [[nodiscard]] std::size_t sensor() const { return place_of(Channel{all_names[name]}.sensor()); }
  /// Not where differences over two readings exceed twice those over one by more than chance, one in twenty:
  /// they are of a slope, not of noise.
  [[nodiscard]] bool tells_correlation() const {
    return near > 0 && ratio <= 2 + 1.64 * correlation_deviation(1, values);
  }
  /// phi, from that where the sensor is read fastest.
  [[nodiscard]] double correlation(const BySensor& fastest) const {
    return std::pow(fastest[sensor()], pace);
  }
};

/// Of every channel, by the paces at which it is read where these matter.
std::vector<Steps> plain_steps(const Measurements& measurements, const std::vector<double>& residual,
                               const Manner& manner);

/// The same, by second differences where these count.
std::vector<Steps> all_steps(const Measurements& measurements, const std::vector<double>& residual,
                             const Manner& manner);

}  // namespace plumbline::diagnose
