#pragma once
/// \file
/// Noise of what a run imposes, where a sensor read it, in what is measured.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

/// Variances that the noise of imposed channels adds to every predicted value, through the nominal model: a
/// trace a run, in squares of SI units. Empty where nothing imposed has noise.
std::vector<Trace> variance_by_imposed(const Experiment& experiment);

}  // namespace plumbline::diagnose
