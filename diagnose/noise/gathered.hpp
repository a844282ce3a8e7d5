#pragma once
/// \file
/// Where the readings that are far out gather.

#include <vector>

#include "diagnose/noise/measurement.hpp"

namespace plumbline::diagnose {

/// Of the marked values those that stand within five readings of a run, in whichever sensor, in three of the
/// readings at least and so many that it is no chance, as many as are marked elsewhere: wild readings come
/// one by one, and what a model misses, a cog or a snap, shows in all that measures it while it lasts. \param
/// marked  flat
std::vector<bool> gathered(const Measurements& measurements, const std::vector<bool>& marked);

}  // namespace plumbline::diagnose
