#pragma once
/// \file
/// Parameters of rows with a threshold angle: stops, and springs with a softer slope beyond a knee.

#include <array>

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// s, the deflection at the threshold.
/// \param turn  unit of the ranges of angles, rad
inline ParameterRange onset_angle(std::string_view name, double turn) {
  return {name, "rad", Coordinate::plain, 0.3 * turn, 1e-5 * turn, 3 * turn};
}

/// k_s, the stiffness of a stop in parallel with a spring. A smoothly stiffening spring resembles a stop that
/// is hardly stiffer than the spring: five of eight such joints on benches of another simulator.
inline ParameterRange stop_stiffness(double spring) {
  ParameterRange range = one_way("k_s", "N m/rad", 10 * spring, 300 * spring);
  range.shape_below = 3 * spring;
  return range;
}

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
