#pragma once
/// \file
/// Keyframes of an edited MJCF.

#include "diagnose/exchange/mjcf_scene.hpp"
#include "diagnose/exchange/tree.hpp"

namespace plumbline::exchange {

/// Says in every keyframe what it lacks of joints and actuators that were added: joints at ease, the drive
/// led to where it starts.
/// \param scene      the model as it was, whose document has been edited since
/// \param actuators  how many it had
void extend_keys(MjcfScene& scene, std::size_t actuators, Pair start);

}  // namespace plumbline::exchange
