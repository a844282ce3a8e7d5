#pragma once
/// \file
/// What happens between two readings, where joints slip: which slips first turns on what happened on the way.

#include <vector>

#include "diagnose/bench/experiment.hpp"
#include "diagnose/rig/run_rig.hpp"

namespace plumbline::diagnose {

/// Into how many parts the way to each reading from the one before is divided: one where nothing slips on it,
/// and so many that the way to the farthest command has 48, for a rig goes steadily where readings are few.
std::vector<std::size_t> parts_of_ways(const Run& run, const Layout& layout, const Rig& rig);

/// A reading that was not taken, a share of the way from one to the next; nothing was measured there.
Reading on_the_way(const Reading& from, const Reading& to, double share);

}  // namespace plumbline::diagnose
