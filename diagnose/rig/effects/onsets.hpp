#pragma once
/// \file
/// Parameters of rows with a threshold angle: stops, and springs with a softer slope beyond a knee.

#include <array>

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// Initial guesses with the threshold at fractions of the largest deflection, each with two sizes.
/// \param at  gives the parameters for a fraction and a size
template <class Parameters>
InitialGuesses onset_guesses(std::initializer_list<double> sizes, Parameters at) {
  InitialGuesses guesses{{}, 2};
  for (const double share : {0.2, 0.4, 0.6, 0.8, 0.92, 0.98})
    for (const double size : sizes) guesses.points.push_back(at(share, size));
  return guesses;
}

/// Initial guesses for stops: a size is the stiffness of the stop over that of the spring.
template <class Parameters>
InitialGuesses stop_guesses(Parameters at) {
  return onset_guesses({1.0, 30.0}, at);
}

}  // namespace plumbline::diagnose
