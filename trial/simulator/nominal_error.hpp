#pragma once
/// \file
/// The rig without any effect against the nominal statics.

#include "trial/simulator/instruments.hpp"

namespace plumbline::simulator {

/// Largest difference, in sigmas, between the states of the rig and the equilibria of core/: of the force or
/// end point, whichever is free, and of joint angles. A sigma of zero leaves a kind out.
double nominal_error(const Plan& plan, const std::vector<std::vector<State>>& states, const Sigma& sigma);

}  // namespace plumbline::simulator
