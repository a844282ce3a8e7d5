#pragma once
/// \file
/// Reads MJCF with the semantics of MuJoCo 3, without MuJoCo.

#include <filesystem>

#include "diagnose/exchange/mjcf_servos.hpp"
#include "diagnose/exchange/planar_chain.hpp"

namespace plumbline::exchange {

/// \throws Error as MjcfScene does, and where an actuator names a joint that is not there
ReadModel read_mjcf(const std::filesystem::path& file);
/// Of what was read already.
ReadModel model_in(const MjcfScene& scene, const MjcfActuators& actuators);

}  // namespace plumbline::exchange
