#pragma once
/// \file
/// Keyframes of an edited MJCF.

#include <mujoco/mujoco.h>

#include "diagnose/exchange/mjcf_document.hpp"
#include "diagnose/exchange/tree.hpp"

namespace plumbline::exchange {

/// Says in every keyframe what it lacks of joints and actuators that were added: joints at ease, the drive
/// led to where it starts.
/// \param own  the model as it was
void extend_keys(MjcfDocument& document, const mjModel& own, Pair start);

}  // namespace plumbline::exchange
