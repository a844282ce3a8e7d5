#pragma once
/// \file
/// The prediction of a run with an arm in space: from pose to pose, with the memory of its joints.

#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

/// The columns of its traces.
Eigen::Index columns_of_arm(const Experiment& experiment);

/// One run of a rig and of its variations; `beside` holds their differences from the rig.
/// \pre the experiment and the rigs have an arm
/// \returns false where there is no rest near some command
bool walk_arm(const Experiment& experiment, const Run& run, const Rig& rig,
              const std::vector<Rig>& variations, Trace& trace, const std::vector<Trace*>& beside);

}  // namespace plumbline::diagnose
