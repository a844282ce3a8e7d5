#pragma once
/// \file
/// Feasible runs of a bench whose loads act along the chain.

#include "diagnose/design/candidate_runs.hpp"

namespace plumbline::diagnose {

/// Runs under imposed forces from the rest shapes in which one value of the loads along the chain goes from
/// its least to its greatest so far, with and without return; the others stay at their means, and nothing
/// acts on the end point. Only those that the nominal chain can follow.
/// \param shapes  of which those with a free end point count
std::vector<CandidateRun> load_sweeps(const Experiment& experiment, const std::vector<Shape>& shapes,
                                      const OperatingEnvelope& so_far);

}  // namespace plumbline::diagnose
