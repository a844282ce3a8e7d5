#pragma once
/// \file
/// Substeps between two readings: the order in which joints slip depends on the path between them.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {

/// Number of substeps from each reading to the next: one where no joint slips, else in proportion to the
/// distance, with 48 to the farthest command of the run.
std::vector<std::size_t> substeps(const Run& run, const Layout& layout, const Rig& rig);

/// A reading between two others, by linear interpolation of the command; nothing is measured there.
Reading interpolated(const Reading& from, const Reading& to, double share);

}  // namespace plumbline::diagnose
