#pragma once
/// \file
/// The fast part of a series, and which tones it has.

#include <Eigen/Core>
#include <cstddef>

namespace plumbline::diagnose {

/// Cosine and sine of a tone, one row a reading.
/// \param clock  when they were read, in intervals
Eigen::MatrixX2d tone(const Eigen::VectorXd& clock, double frequency);

/// Of cosine and sine, by least squares.
Eigen::Vector2d amplitudes(const Eigen::VectorXd& values, const Eigen::MatrixX2d& waves);

/// What is left of values without their slow components.
Eigen::VectorXd fast_part(const Eigen::VectorXd& values);

/// Frequency a reading below which a tone of so many readings is slow.
double slowest_tone(std::size_t count);

/// Frequencies at which a spectrum is looked at: four an ordinate, so that a line between two of these loses
/// nothing.
inline constexpr int looks_an_ordinate = 4;
double looked_at(std::size_t count, Eigen::Index look);

/// Independent ones among them, those of the periodogram.
double ordinates(std::size_t count);

/// At each look the share of the energy of fast values that a tone explains, as innovations of noise whose
/// neighbours correlate.
Eigen::VectorXd tone_shares(const Eigen::VectorXd& fast, const Eigen::VectorXd& clock, double correlation);

}  // namespace plumbline::diagnose
