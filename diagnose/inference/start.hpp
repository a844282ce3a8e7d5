#pragma once
/// \file
/// Where fits start: several places where the derivative by a parameter vanishes at the nominal model.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Initial guesses for one effect, as its row says, within its bounds.
InitialGuesses initial_guesses(const Study& study, const EffectAt& at);

/// All combinations for several effects.
InitialGuesses initial_guesses(const Study& study, const Candidate& candidate);

}  // namespace plumbline::diagnose
