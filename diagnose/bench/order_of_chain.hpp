#pragma once
/// \file
/// Lists that were written from the end point on instead of from the base.

#include <vector>

#include "diagnose/bench/conversion.hpp"

namespace plumbline::diagnose {

/// One list alone, all of the chain's, and with them the angles at rest, the measured angles, or both. In a
/// symmetric chain angles alone can be reversed (add_angles).
void add_order_of_chain(const Experiment& e, std::vector<Conversion>& all);

}  // namespace plumbline::diagnose
