#pragma once
/// \file
/// Long runs, drawn together: a logger takes thousands of readings where a curve has some hundred places.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The experiment with the readings of long runs drawn together: each group of neighbours becomes one reading
/// with the mean of what was commanded and the median of what was measured, which a few outliers do not move.
/// About five hundred readings remain, forty at least of each run. What a chain remembers stays: the first
/// and last command and every turning point stand alone, without their measured values. An experiment that is
/// short comes back as it is.
Experiment condensed(Experiment experiment);

}  // namespace plumbline::diagnose
