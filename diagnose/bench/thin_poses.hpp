#pragma once
/// \file
/// Fewer poses of an arm that took thousands.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Keeps about eight hundred readings of an arm, in blocks of neighbours spread evenly over each run; a short
/// experiment is returned unchanged. The first reading of each block but a run's first has no measured
/// values: the pose from which it was approached is left out, and with it the side on which friction holds.
/// \pre the experiment is of an arm in space
Experiment thinned(Experiment experiment);

}  // namespace plumbline::diagnose
