#pragma once
/// \file
/// The rig as a MuJoCo model in MJCF, its XML language.

#include <string>

#include "trial/simulator/physics.hpp"

namespace plumbline::simulator {

/// How fast the model answers. Every hinge and slide gets the armature and the damping with which it alone,
/// on its own spring, settles at the critical damping with the time constant `response`. Statics does not
/// depend on it.
struct Pace {
  double response;  ///< s
  double timestep;  ///< s
};

/// Bodies link1 … linkn with the hub hinges q1 … qn, the body `tip`
/// with the site `end` on the end point. Native: springs, link weights, payload, base and train springs,
/// bars that stretch, beams as hinges at the three Gauss points of each link (so that the compliance to end
/// loads is exact to first order), the tip spring, the band. Everything else is a passive force.
std::string mjcf(const Plan& plan, const Physics& physics, const PlannedRun& run, const Pace& pace);

}  // namespace plumbline::simulator
