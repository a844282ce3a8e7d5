#pragma once
/// \file
/// From a fit to the same with one element fewer or more, of an effect that is made of several.

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// Where fits start when the effect at this place of the candidate becomes the row, which has one element
/// fewer or more of it: each two neighbours made one, or one added before, between and after those that there
/// are. Nothing where the row is farther away.
InitialGuesses initial_guesses_of_order(const Study& study, const Hypothesis& fitted, std::size_t effect,
                                        const Effect& row);

}  // namespace plumbline::diagnose
