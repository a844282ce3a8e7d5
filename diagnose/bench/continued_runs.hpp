#pragma once
/// \file
/// One loading history that was written as several runs.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Appends a run to the one before it where it goes on there: the same control and rest, the clock and the
/// command go on within two usual steps, and the command is far from the unloaded chain, with which a run
/// begins. Friction and relaxation remember what a break between two runs would make them forget. The names
/// of appended runs are kept in Run::continued_by.
void join_continued(Experiment& experiment);

}  // namespace plumbline::diagnose
