#pragma once
/// \file
/// The user's own SDF with the correction in it.

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// The model's source, where the cause asks for it another: springs, ranges and friction of joints, poses,
/// links and joints beside those that are there, gravity. What is not touched stays as it stands.
/// \pre model.source is the SDF that the nominal chain was read from
/// \throws Error where the file cannot be edited, with what stands against it
Written edit_sdf(const Model& model);

}  // namespace plumbline::exchange
