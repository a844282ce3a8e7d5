#pragma once
/// \file
/// What looks odd in readings, whatever the model: a remark to who took them, no reason to refuse them.

#include <string>
#include <vector>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// Sentences, each with the run: a sensor that stands still, a lone spike, readings missing, a noise that is
/// not there, a pause, a start away from the unloaded end point, a force at rest, a run twice.
std::vector<std::string> anomalies(const Experiment& experiment);

}  // namespace plumbline::diagnose
