#pragma once
/// \file
/// What no reading of a real chain can show.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// \throws Error, one line with run and reading, where the experiment cannot be physical or cannot be judged:
///         a commanded or measured end point out of reach, joint angles that put the end point elsewhere, a
///         measured channel whose declared noise is zero, a mechanism, too few measured values
void require_physical(const Experiment& experiment);

}  // namespace plumbline::diagnose
