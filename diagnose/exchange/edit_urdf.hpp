#pragma once
/// \file
/// The user's own URDF with the correction in it.

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// The model's source, where the cause asks for it another: springs in <gazebo>, dry friction, origins of
/// joints, links and joints beside those that are there. What is not touched stays as it stands.
/// \pre model.source is the URDF that the nominal chain was read from
/// \throws Error where the file cannot be edited, with what stands against it
Written edit_urdf(const Model& model);

}  // namespace plumbline::exchange
