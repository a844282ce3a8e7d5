#pragma once
/// \file
/// The fast part of a series, and which tones it has.

#include <Eigen/Core>
#include <cstddef>

namespace plumbline::diagnose {

/// Cosine and sine of a tone, one row a reading.
/// \param clock  when they were read, in intervals
Eigen::MatrixX2d tone(const Eigen::VectorXd& clock, double frequency);

/// Takes what is slow from series of so many readings.
class Fast {
 public:
  explicit Fast(std::size_t count);
  /// What is left of each column without its slow components.
  [[nodiscard]] Eigen::MatrixXd part(const Eigen::MatrixXd& columns) const;
  /// Amplitudes of cosine and sine of a tone that leave least of values, but for what is slow.
  [[nodiscard]] Eigen::Vector2d amplitudes(const Eigen::VectorXd& values,
                                           const Eigen::MatrixX2d& waves) const;

 private:
  Eigen::MatrixXd slow_;  ///< orthonormal, a column each
};

/// Frequency a reading below which a tone of so many readings is slow.
double slowest_tone(std::size_t count);

/// Frequencies at which a spectrum is looked at: four an ordinate, so that a line between two of these loses
/// nothing.
inline constexpr int looks_an_ordinate = 4;
double looked_at(std::size_t count, Eigen::Index look);

/// Independent ones among them, those of the periodogram.
double ordinates(std::size_t count);

/// The share of the energy of values, but for what is slow, that a tone explains, as innovations of noise
/// whose neighbours correlate.
double tone_share(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double frequency,
                  double correlation);

/// The same at each look.
Eigen::VectorXd tone_shares(const Eigen::VectorXd& values, const Eigen::VectorXd& clock, double correlation);

}  // namespace plumbline::diagnose
