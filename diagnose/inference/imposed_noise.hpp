#pragma once
/// \file
/// Noise of what is imposed on a joint alone, where a sensor read it, in what is measured.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

/// Variances that the noise of an imposed angle or torque adds to every predicted value of a joint alone,
/// through the nominal model: a trace a run, in squares of SI units. Empty where nothing imposed has noise;
/// that of a chain's imposed channels does not count.
std::vector<Trace> variance_by_imposed(const Experiment& experiment);

}  // namespace plumbline::diagnose
