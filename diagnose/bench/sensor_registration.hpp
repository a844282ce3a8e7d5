#pragma once
/// \file
/// Where the sensors of an arm stand that are no tracker, and where the points sit that they alone see.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Moves every sensor, the focal length of a camera that is not known, and a point that nothing else has
/// placed to where its readings fit best: by Levenberg and Marquardt's method from where they are said to be,
/// and from every orientation that turns axes into axes, geometry nominal and joints at their commands.
/// Nothing moves where there are fewer readings than unknowns.
void register_sensors(Experiment& experiment);

}  // namespace plumbline::diagnose
