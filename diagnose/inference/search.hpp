#pragma once
/// \file
/// The search for hypotheses: which effects may act, fitted and weighed.

#include <functional>
#include <memory>

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// What was found of an experiment. Hypotheses point into `outside` and the catalogue.
struct Findings {
  std::shared_ptr<const CommandStates> states;
  std::shared_ptr<const std::vector<Effect>> outside;  ///< rows of unknown torques
  std::shared_ptr<const Likelihood> likelihood;
  Look nominal;                        ///< what the likelihood says of the nominal model
  std::vector<Hypothesis> hypotheses;  ///< most evidence first
  std::vector<EffectAt> not_excited;   ///< effects on which no measured value depends
  std::vector<EffectAt> untimed;       ///< effects of time, where the readings have no clock
};

/// Fits every effect, alone and then beside those that explain most; takes the leading hypotheses apart and
/// puts every other effect in the place of each of theirs; and weighs all by the noise that the best of them
/// leaves.
/// \param progress  called with the share of the work that is done
Findings search(const Study& study, const std::function<void(double)>& progress = {});

}  // namespace plumbline::diagnose
