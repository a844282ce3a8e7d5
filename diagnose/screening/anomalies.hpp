#pragma once
/// \file
/// Anomalies in readings that need no model: remarks to whoever took them, not errors.

#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Sentences, each with its run: a sensor that stays constant, a lone spike, missing readings, less noise
/// than declared, a pause, a start away from the unloaded end point, a force at rest, a repeated run.
std::vector<std::string> anomalies(const Experiment& experiment);

}  // namespace plumbline::diagnose
