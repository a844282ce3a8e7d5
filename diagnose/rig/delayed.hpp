#pragma once
/// \file
/// Commands that a drive follows with a delay.

#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The readings of a run with what its drives impose as it was commanded so much earlier: joint angles, a
/// place, or a force by a load cell. Between readings commands are interpolated; before the first one they
/// stood still, or came along the line of a run that begins moving. Weights hang without delay.
/// \param delay  s, zero or more
std::vector<Reading> delayed(const Run& run, double delay);

}  // namespace plumbline::diagnose
