#pragma once
/// \file
/// From a fit to the same with one element fewer or more, of an effect that is made of several.

#include "diagnose/inference/fit.hpp"

namespace plumbline::diagnose {

/// Where fits start when the effect at this place of the candidate becomes the row, which has one element
/// fewer or more of it: each two neighbours made one, or one added before, between and after those that there
/// are.
InitialGuesses in_number(const Study& study, const Fit& fitted, std::size_t effect, const Effect& row);

}  // namespace plumbline::diagnose
