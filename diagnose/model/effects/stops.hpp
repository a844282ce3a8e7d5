#pragma once
/// \file
/// What the rows of stops share: of one joint, of all alike, and with an angle of its own at each.

#include "diagnose/model/effect.hpp"

namespace plumbline::diagnose {

/// Deflection at which a stop is reached, s.
inline ParameterRange stop_angle(std::string_view name) {
  return {name, "rad", Coordinate::plain, 0.3, 1e-3, 3};
}

/// k_s, beside a spring of this stiffness.
inline ParameterRange stop_stiffness(double spring) {
  return one_way("k_s", "N m/rad", spring, 100 * spring);
}

/// Soft and hard stops that begin at shares of the largest deflection.
/// \param at  parameters of one, from the share and its stiffness over that of the spring
template <class Parameters>
Starts stop_starts(Parameters at) {
  Starts starts{{}, 2};
  for (const double share : {0.2, 0.4, 0.6, 0.8, 0.95})
    for (const double stiff : {0.3, 3.0}) starts.from.push_back(at(share, stiff));
  return starts;
}

}  // namespace plumbline::diagnose
