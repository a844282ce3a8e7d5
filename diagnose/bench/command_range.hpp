#pragma once
/// \file
/// Between which values the joints of a bench are commanded, or its loads along the chain.

#include <algorithm>
#include <limits>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Of one joint over all runs, rad, or m for one that slides; or of one value of a load. Nothing is commanded
/// where high < low.
struct CommandRange {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// From `low`, 0, to `high`, 1.
  [[nodiscard]] double at(double share) const { return low + share * (high - low); }
};

/// By joint.
std::vector<CommandRange> command_ranges(const Experiment& experiment);

}  // namespace plumbline::diagnose
