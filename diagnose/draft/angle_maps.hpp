#pragma once
/// \file
/// From the angles of a simulator's joints to those of the chain: an affine map each.

#include "diagnose/draft/drafted_run.hpp"

namespace plumbline::diagnose {

/// Whether the readings are of the model's own joints, and not of the chain's. The end points that were read
/// tell; without any, angles are those of the model.
/// \returns false where both are the same
bool reads_joints_of_model(const DraftedRun& run, const DraftModel& model);

/// Signs and zeros of columns of all joints, so that the chain's angles come out of the model's.
void take_angle_maps(const DraftModel& model, std::vector<DraftColumn>& angles);

}  // namespace plumbline::diagnose
