#pragma once
/// \file
/// Feasible runs of joints that are commanded: poses to hold and slow sweeps, bare and with a weight.

#include "diagnose/design/candidate_runs.hpp"

namespace plumbline::diagnose {

/// Poses between the farthest commands so far, and a sweep of each joint there and back between its own; each
/// again with a weight at the end point, where the plane is not horizontal: the largest force so far, or one
/// that deflects the nominal chain as far as it was deflected before. Empty where no joint was commanded.
std::vector<CandidateRun> commanded_runs(const Experiment& experiment, const OperatingEnvelope& so_far);

}  // namespace plumbline::diagnose
