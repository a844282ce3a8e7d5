#pragma once
/// \file
/// The nominal model of an experiment: the simulator whose gap is diagnosed.

#include <plumbline/loaded/nominal_model.hpp>

#include "diagnose/bench/experiment.hpp"

namespace plumbline::diagnose {

/// The nominal chain with the weight of its links, as commanded in one run.
NominalModel<double> nominal_model(const Experiment& experiment, const std::vector<double>& rest);

}  // namespace plumbline::diagnose
