#pragma once
/// \file
/// A tone in one series of readings.

#include <Eigen/Core>

#include "diagnose/noise/measurement.hpp"

namespace plumbline::diagnose {

/// A tone in a series of readings.
struct Hum {
  std::size_t series;                ///< place in `Measurements::series`
  double period;                     ///< readings
  double cosine, sine;               ///< amplitudes at the first reading, declared sigmas
  [[nodiscard]] double rms() const;  ///< declared sigmas
};

/// So many a series may have.
inline constexpr long most_tones = 2;

/// Whether a series may have any: a spectrum of fewer ordinates has no line.
bool long_enough(const Series& series);

/// When the readings of a series were made, in mean intervals.
Eigen::VectorXd clock_of(const Series& series);

/// A series of a flat residual.
Eigen::VectorXd values_of(const Series& series, const std::vector<double>& residual);

/// The tone of this frequency in values, beside what is slow; its series is the first.
Hum tone_of(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency);

/// A slow tone, and how far noise alone would fall behind.
struct Slow {
  Hum tone;
  double loud;
};

/// The tone of this frequency in values, beside their mean where it goes round; of less than a round the mean
/// is a part.
Slow slow_tone(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency, bool round);

/// What a tone adds to the values of its series, declared sigmas.
Eigen::VectorXd wave_of(const Series& series, const Hum& one);

/// The residual without these tones.
std::vector<double> without_hum(const Measurements& measurements, std::vector<double> residual,
                                const std::vector<Hum>& hum);

}  // namespace plumbline::diagnose
