#pragma once
/// \file
/// A census as boxes that anyone can check one by one.

#include <string>
#include <vector>

#include "proofs/census/equilibrium_box.hpp"

namespace plumbline::proofs {

/// A tree of halvings of all link directions: `a` halves that of link 1, `b` that of link 2 and so on, the
/// lower half first; `.` is a box in which is nothing, or what lies in one of the balls.
/// \param balls  in the system's units, passive joints in any turn
/// \throws Error where more than a million boxes are needed
std::string covering(const EquilibriumBox& system, const std::vector<Box>& balls);

}  // namespace plumbline::proofs
