#pragma once
/// \file
/// What no reading of a real chain can show.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// \throws Error, one line with run and reading, where the experiment cannot be physical or cannot be judged:
///         a commanded or measured end point out of reach, a rest angle of thousands of turns, joint angles
///         that put the end point elsewhere, a measured channel whose declared noise is zero, a mechanism,
///         too few measured values
void require_physical(const Experiment& experiment);

/// The same of a bench before anything is measured: its chain, what its runs command, its noise.
/// \throws Error as above, and where a run measures nothing: no channel of it has a noise
void require_bench(const Experiment& bench);

}  // namespace plumbline::diagnose
