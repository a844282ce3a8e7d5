#pragma once
/// \file
/// Experiments that no real chain can produce.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// \throws Error, one line with run and reading, where the experiment cannot be physical or cannot be judged: an end
///         point out of reach, a rest angle of thousands of turns, joint angles that contradict the end
///         point, a measured channel with a declared noise of zero, a mechanism, too few measured values
void require_physical(const Experiment& experiment);

/// The same for a bench before any measurement: its chain, its commands, its noise.
/// \throws Error as above, and where a run measures nothing because no channel of it has a noise
void require_bench(const Experiment& bench);

}  // namespace plumbline::diagnose
