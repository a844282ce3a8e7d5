#pragma once
/// \file
/// Where in a run a sensor begins to scatter more or less, found in the readings themselves: no model enters.

#include <cstddef>
#include <vector>

#include "diagnose/noise/differences.hpp"
#include "diagnose/noise/series.hpp"

namespace plumbline::diagnose {

/// How large the third difference about a reading is.
struct Loudness {
  std::size_t reading;  ///< of the run
  double size;          ///< of either sign, in any unit
};

/// Readings at which a stretch begins that scatters otherwise than what is before, ascending; a proposal, for
/// some noise that is the same throughout has one as well. No stretch has fewer than twenty differences.
/// \param run  by reading, of all channels of a sensor
std::vector<std::size_t> stretch_borders(const std::vector<Loudness>& run);

/// By run, the stretches in which a sensor scatters more than elsewhere: of those that are proposed, what
/// uneven_noise() tells of them beside the others.
/// \param values  of each series
std::vector<std::vector<RoughStretch>> rough_stretches(const Experiment& experiment,
                                                       const std::vector<Series>& series,
                                                       const std::vector<std::vector<double>>& values,
                                                       Sensor sensor);

/// What the values of a series show of their noise, each in its sigma, stretch by stretch.
SeenNoise seen_noise(const Run& run, const Series& series, const std::vector<double>& values);

}  // namespace plumbline::diagnose
