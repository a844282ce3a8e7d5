#pragma once
/// \file
/// The user's own MJCF with the correction in it.

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// The model's source, where the cause asks for it another: joints' attributes, places of bodies, joints
/// beside those that are there, tendons and actuators beside those. What is not touched stays as it stands.
/// \pre model.source is the MJCF that the nominal chain was read from
/// \throws Error where the file cannot be edited, with what stands against it
Written edit_mjcf(const Model& model);

}  // namespace plumbline::exchange
