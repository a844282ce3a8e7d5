#pragma once
/// \file
/// A bench before any measurement.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The experiment in which exactly the channels with a noise are measured, with empty values.
Experiment unmeasured(Experiment experiment);

}  // namespace plumbline::diagnose
