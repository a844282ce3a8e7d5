#pragma once
/// \file
/// Runs that go the same way: what tells their readings at the same place apart is noise, or what changes
/// from run to run, and not the shape of a curve, however finely it is wrinkled.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/noise/series.hpp"

namespace plumbline::diagnose {

/// The values of one channel in runs that go the same way, the runs one after the other.
struct Repeats {
  Channel channel{};
  std::vector<std::size_t> values;  ///< their places in the flat list
  std::vector<Between> between;     ///< by their number here
};

/// Of all channels; none where no run goes the way of another.
std::vector<Repeats> repeats(const Experiment& experiment, const std::vector<Series>& series);

}  // namespace plumbline::diagnose
