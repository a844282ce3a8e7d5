#pragma once
/// \file
/// Linear forecasts: what each effect would explain of what a hypothesis leaves.

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// An effect that might act beside those of a hypothesis.
struct Prospect {
  EffectAt effect;
  InitialGuesses starts;  ///< of both, the parameters of the hypothesis first
  double cost;            ///< forecast of the sum of squares, with what Gaussian priors charge
};

/// Forecasts every possible effect beside a hypothesis, the most promising first: score tests that share one
/// prediction. An effect whose derivative depends on where it acts is probed at several places; one of which
/// little acts otherwise than much, by a finite step.
/// \param weight  by value: one over its noise in declared sigmas, zero of outliers
std::vector<Prospect> forecast(const Study& study, const VectorXd& weight,
                               const std::vector<EffectAt>& possible, const Hypothesis& beside);

}  // namespace plumbline::diagnose
