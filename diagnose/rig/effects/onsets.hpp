#pragma once
/// \file
/// What the rows share that set in beyond an angle: stops, and springs that give way.

#include <array>

#include "diagnose/rig/effect.hpp"

namespace plumbline::diagnose {

/// Deflection at which a stop is reached, or a spring gives way, s.
inline ParameterRange onset_angle(std::string_view name) {
  return {name, "rad", Coordinate::plain, 0.3, 1e-3, 3};
}

/// k_s, beside a spring of this stiffness. Of eight benches of another simulator in which one joint stiffened
/// smoothly five were named a stop, at a small angle and hardly stiffer than the spring.
inline ParameterRange stop_stiffness(double spring) {
  ParameterRange range = one_way("k_s", "N m/rad", spring, 100 * spring);
  range.shape_below = 3 * spring;
  return range;
}

/// What begins at shares of the largest deflection, each with little and with much of it.
/// \param at  parameters of one, from the share and how much
template <class Parameters>
InitialGuesses onset_guesses(const std::array<double, 2>& sizes, Parameters at) {
  InitialGuesses guesses{{}, 2};
  for (const double share : {0.2, 0.4, 0.6, 0.8, 0.95})
    for (const double size : sizes) guesses.points.push_back(at(share, size));
  return guesses;
}

/// Soft and hard stops: how much is their stiffness over that of the spring.
template <class Parameters>
InitialGuesses stop_guesses(Parameters at) {
  return onset_guesses({0.3, 3.0}, at);
}

}  // namespace plumbline::diagnose
