#pragma once
/// \file
/// Substeps between two readings: the order in which joints slip depends on the path between them.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {

/// Number of substeps to each reading from the one before it. Commanded links turn by 0.25 rad in one at
/// most. Where an end is led, or loads act along the chain, and joints slip, there are as many besides as in
/// proportion to the distance make 48 to the farthest command of the run.
/// \param sliders  of each joint, in the rig and those beside it
std::vector<std::size_t> substeps(const Run& run, std::size_t sliders, const Rig& rig);

/// Whether the torque of some joint depends on the way on which it came.
/// \param sliders  of each joint
bool remembers(const Rig& rig, std::size_t sliders);

}  // namespace plumbline::diagnose
