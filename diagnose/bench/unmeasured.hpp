#pragma once
/// \file
/// A bench before anything is measured.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The experiment with every channel that has a noise measured, its values empty, and no other.
Experiment unmeasured(Experiment experiment);

}  // namespace plumbline::diagnose
