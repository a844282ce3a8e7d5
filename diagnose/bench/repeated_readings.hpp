#pragma once
/// \file
/// Readings that a logger wrote again before its sensor had a new one.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The run without them, as a thinned one: the first of equal neighbours stays. Neighbours with equal
/// commands scatter by the noise, and are equal by chance as often as the steps of the values beside it
/// allow. Readings are repeated where that is less probable than a logger that repeats any share of them, of
/// which one in twenty does.
Run without_repeated_readings(Run run, const Noise& noise);

}  // namespace plumbline::diagnose
