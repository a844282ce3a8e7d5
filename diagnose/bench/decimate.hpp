#pragma once
/// \file
/// Long runs, drawn together: a logger takes thousands of readings where a curve has some hundred places.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The experiment with the readings of long runs drawn together: each group of neighbours becomes one reading
/// with the mean of what was commanded and the median of what was measured, off how it goes there: a median
/// that few outliers move, and that scatters no more where a run goes fast. About five hundred readings
/// remain, forty at least of each run (twenty where there are fifty), and ten of every way from end to end of
/// it: a run that goes often keeps more. What a chain remembers stays: the first and last command and every
/// turning point, but for the unrest of a logged position, stand alone, without their measured values. An
/// experiment that is short comes back as it is, and a run that turns all the time.
Experiment decimated(Experiment experiment);

}  // namespace plumbline::diagnose
