#pragma once
/// \file
/// Feasible next poses of an arm in space.

#include <vector>

#include "diagnose/design/candidate_runs.hpp"

namespace plumbline::diagnose {

/// Runs of one pose each, evenly spread over the limits of the joints, or over what was commanded where there
/// are none; each without a load and with the heaviest so far. What is measured is as in the first reading.
std::vector<CandidateRun> candidate_poses(const Experiment& experiment);

}  // namespace plumbline::diagnose
