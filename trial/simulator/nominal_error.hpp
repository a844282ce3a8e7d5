#pragma once
/// \file
/// The rig without any effect against the nominal statics.

#include "trial/simulator/instruments.hpp"

namespace plumbline::simulator {

/// The largest difference between the states that the rig reached and the equilibria of core's solver beside
/// them: of the force where the end point is imposed, of the end point where the force is, and of the joint
/// angles. In sigmas; a sigma of zero leaves its kind out.
double nominal_error(const Plan& plan, const std::vector<std::vector<State>>& states, const Sigma& sigma);

}  // namespace plumbline::simulator
