#pragma once
/// \file
/// Stuck channels: measured columns that stay constant while the chain moves.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// A measured column that keeps one value where the nominal model moves far: a sensor that is not connected,
/// or zeros for missing values.
struct StuckChannel {
  std::vector<std::string> runs;  ///< affected runs; empty for all
  Channel channel;
  std::set<double> values;  ///< one for each run, SI
  std::size_t readings;     ///< number of readings with these values
  double predicted_range;   ///< largest range of the nominal model in one of the runs, SI
};

/// The first channel that is stuck in some run: at least eight readings, all equal to the last digit, where
/// the nominal model moves by more than twenty times the noise and a fiftieth of the range of the sensor.
/// Noise shows in the last digits of a working sensor, and where these are too coarse the chain moves by less
/// than twenty times the noise.
std::optional<StuckChannel> stuck_channel(const Study& study);

/// \throws Error, one line, for a stuck channel
void require_no_stuck_channel(const Study& study);

}  // namespace plumbline::diagnose
