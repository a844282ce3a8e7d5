#pragma once
/// \file
/// Where fits start: several places where the derivative by a parameter vanishes at the nominal model.

#include <vector>

#include "diagnose/model/history.hpp"

namespace plumbline::diagnose {

/// Parameter vectors from which to fit. All are looked at, the `basins` best are descended from.
struct Starts {
  std::vector<std::vector<double>> from;
  std::size_t basins;
};

/// Starts for one effect.
Starts starts(const Experiment& experiment, const EffectAt& at);

/// All combinations for several effects.
Starts starts(const Experiment& experiment, const Candidate& candidate);

}  // namespace plumbline::diagnose
