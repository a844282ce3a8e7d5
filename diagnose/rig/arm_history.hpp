#pragma once
/// \file
/// The prediction of an experiment with an arm in space: from pose to pose, with the memory of its joints.

#include "diagnose/rig/history.hpp"

namespace plumbline::diagnose {

/// Predicts all runs, and the difference quotients by the variations.
/// \pre the experiment and the rig have an arm
Prediction simulate_arm(const Experiment& experiment, const Rig& rig,
                        const std::vector<RigVariation>& variations);

}  // namespace plumbline::diagnose
