#pragma once
/// \file
/// The values of one channel in one run.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "diagnose/bench/channel.hpp"
#include "diagnose/noise/between.hpp"

namespace plumbline::diagnose {

/// Readings of a run, from one to before another, in which a sensor scatters so many times as much as
/// elsewhere.
struct RoughStretch {
  std::size_t from = 0, to = 0;
  double times = 1;
};

/// The values of one channel in one run, in the order in which they were taken, without the missing ones.
struct Series {
  std::size_t run = 0;
  Channel channel{};
  double sigma = 0;                   ///< declared noise, times how many times more it scatters than others
  std::size_t first = 0;              ///< place of its first value in the flat list
  std::vector<std::size_t> readings;  ///< index of each value's reading in the run
  double interval = 0;                ///< mean time from value to value, s; 0 of one value
  double pace = 1;               ///< interval, in that of the run in which its kind of sensor is read fastest
  std::vector<double> clock;     ///< when each was read, intervals after the first; its number without times
  std::vector<Between> between;  ///< where its run went the same way more than once
  /// Of each value: the declared one, wider in rough stretches, where the readings scatter in proportion to
  /// themselves, and where coarse ones repeat.
  std::vector<double> sigmas;
  double proportion = 0;  ///< that part over the declared sigma, per unit of the reading; mostly 0
  double step = 0;        ///< that coarse readings are rounded to, declared sigmas; 0 where none shows
  double roughness = 0;   ///< of the readings themselves, in sigmas: their noise is hardly larger
  /// How many times more it scatters than the angles of the other joints do, and than the same sensor in the
  /// other runs; mostly 1.
  double beside_joints = 1, beside_runs = 1;
  std::vector<RoughStretch> rough;  ///< of it, ascending
  /// Its own, made of its readings: begins random numbers that do not depend on the order of the runs.
  std::vector<std::uint32_t> seed;

  /// How many times as much a reading of the run scatters for the stretch that it is in.
  [[nodiscard]] double roughness_at(std::size_t reading) const {
    for (const RoughStretch& one : rough)
      if (reading >= one.from && reading < one.to) return one.times;
    return 1;
  }
};

}  // namespace plumbline::diagnose
