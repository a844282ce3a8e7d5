#pragma once
/// \file
/// Which effect to try next: what a linear forecast says that each would explain of what a fit leaves.

#include <vector>

#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// An effect that might act beside those of a fit.
struct Prospect {
  EffectAt effect;
  /// Where a fit of both may start, the parameters of the fit's own effects first: these as they are, beside
  /// as much of the newcomer as is forecast; where a little of it acts as much of it does, beside nothing of
  /// it, from where a fit cannot end with more than is left now; readjusted to what is forecast; and where a
  /// little of it acts otherwise, readjusted to much of it, for less may be nothing.
  std::vector<std::vector<double>> from;
  double cost;  ///< forecast of the cost with it, the fit's own parameters readjusted
};

/// Forecasts every possible effect beside a fit, the most promising first: the score test of each. All of
/// them ride along with one prediction, so that the whole screen costs about as much as a few fits. An effect
/// whose derivative depends on where it acts (a stop's angle, a time constant) is probed at several places.
std::vector<Prospect> screen(const Study& study, const Fit& fitted, const FitSettings& settings);

}  // namespace plumbline::diagnose
