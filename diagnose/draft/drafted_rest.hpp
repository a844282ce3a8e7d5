#pragma once
/// \file
/// The unloaded shape of a drafted run.

#include <vector>

#include "diagnose/draft/drafted_run.hpp"

namespace plumbline::diagnose {

/// That of the commanded angles, the model's, or that of a first reading without load; else it is asked for.
/// \param commands  columns of the commanded angles of all joints, or none
/// \throws Error for an answer that is no angle for each joint
void find_rest(DraftedRun& run, const DraftModel& model, const Ask& ask,
               const std::vector<DraftColumn>& commands);

}  // namespace plumbline::diagnose
