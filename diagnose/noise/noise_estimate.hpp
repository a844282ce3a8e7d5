#pragma once
/// \file
/// The noise of the readings as it is estimated, beside what was declared.

#include "diagnose/noise/noise_shape.hpp"

namespace plumbline::diagnose {

/// The noise of a channel.
struct ChannelNoise {
  Channel channel;
  double scale;               ///< over the declared one
  double correlation;         ///< of successive readings
  double discrepancy_length;  ///< over the largest command
};

struct NoiseEstimate {
  std::vector<ChannelNoise> channels;
  NoiseShape shape;

  /// \pre the channel is measured
  [[nodiscard]] const ChannelNoise& of(const Channel& channel) const;
  /// The largest scale of the measured channels of a kind; one where none is measured.
  [[nodiscard]] double scale_of(Channel::Name name) const;
  /// By value: standard deviation, declared sigmas.
  [[nodiscard]] VectorXd sigma(const Measurements& measurements) const;
  /// Columns of values in declared sigmas as innovations, in standard deviations; outliers are zero.
  [[nodiscard]] MatrixXd whitened(const Measurements& measurements, const MatrixXd& columns) const;
};

/// Innovations of values in the order of reading, standardised: of noise of this scale that correlates so
/// from one to the next they are independent and of variance one.
VectorXd innovations(const VectorXd& values, double scale, double correlation);

}  // namespace plumbline::diagnose
