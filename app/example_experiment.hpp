#pragma once
/// \file
/// The experiment in examples/experiment, which the verb diagnose works on when it is given none.

#include "diagnose/experiment.hpp"

namespace plumbline {

Experiment example_experiment();

}  // namespace plumbline
