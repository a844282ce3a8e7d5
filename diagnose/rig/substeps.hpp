#pragma once
/// \file
/// Substeps between two readings: the order in which joints slip depends on the path between them.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {

/// Number of substeps to each reading from the one before it: one where no joint slips, else in proportion to
/// the distance, with 48 to the farthest command of the run. Commanded links turn by 0.25 rad in one at most.
std::vector<std::size_t> substeps(const Run& run, const Layout& layout, const Rig& rig);
}  // namespace plumbline::diagnose
