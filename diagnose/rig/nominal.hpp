#pragma once
/// \file
/// The nominal model of an experiment: the simulator whose gap is diagnosed.

#include <plumbline/loaded/nominal_model.hpp>

#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The nominal chain without its effects, with the weight of its links, as commanded in one run.
NominalModel<double> nominal_model(const Experiment& experiment, const std::vector<double>& rest);

/// The rig that the nominal model believes in: the chain, its weights and, through their rows of the
/// catalogue, its effects. \throws Error, one line, for an effect, a joint or a parameter that the catalogue
/// does not have, and for what no rig can be
Rig nominal_rig(const Experiment& experiment);

}  // namespace plumbline::diagnose
