#pragma once
/// \file
/// Where fits start: several places where the derivative by a parameter vanishes at the nominal model.

#include <vector>

#include "diagnose/forward_model.hpp"

namespace plumbline {

/// Parameter vectors from which to fit one effect.
/// \param nominal  the nominal prediction: it says how far each joint goes
std::vector<std::vector<double>> starts(const Experiment& experiment, const Prediction& nominal,
                                        const EffectAt& at);

/// All combinations for several effects.
std::vector<std::vector<double>> starts(const Experiment& experiment, const Prediction& nominal,
                                        const Candidate& candidate);

}  // namespace plumbline
