#pragma once
/// \file
/// Decimation of long runs: a logger takes thousands of readings where a curve has a hundred distinct places.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Replaces each group of neighbouring readings of a long run by one reading: the mean command and, for each
/// channel, the median of its values after removal of a local trend. The median resists outliers, and the
/// trend keeps its scatter independent of the speed of the run. About five hundred readings remain, at least
/// forty of each run (twenty where there are fifty runs), and ten of every sweep: a run with many sweeps
/// keeps more. The history of the chain is preserved: the first and last command and every turning point stay
/// as readings without measured values; jitter of a logged position is no turning point. A short experiment,
/// or a run that reverses continually, is returned unchanged.
Experiment decimated(Experiment experiment);

}  // namespace plumbline::diagnose
