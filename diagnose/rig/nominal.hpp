#pragma once
/// \file
/// The nominal model of an experiment, whose gap is diagnosed.

#include <plumbline/loaded/nominal_model.hpp>

#include "diagnose/rig/rig.hpp"

namespace plumbline::diagnose {

/// The nominal chain with the weight of its links, without its effects, at the rest angles of one run.
NominalModel<double> nominal_model(const Experiment& experiment, const std::vector<double>& rest);

/// The rig of the nominal model: the chain, its weights and its effects.
/// \throws Error for an effect, a joint or a parameter that the catalogue does not have, and for values that
/// no
///         rig can have
Rig nominal_rig(const Experiment& experiment);

}  // namespace plumbline::diagnose
