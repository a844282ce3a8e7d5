#pragma once
/// \file
/// The experiment in examples/experiment, which the verb diagnose works on when it is given none.

#include "diagnose/bench/experiment.hpp"

namespace plumbline::app {

diagnose::Experiment example_experiment(const diagnose::NominalChain* model = nullptr);
/// Its bench, before anything was measured.
diagnose::Experiment example_bench(const diagnose::NominalChain* model = nullptr);

}  // namespace plumbline::app
