#pragma once
/// \file
/// MJCF, the format of MuJoCo.

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// The chain in the plane of x and y, joints q1 to qn about z, the sites end (the end point) and load (where
/// forces on it act). Armature and damping are made up: statics knows none.
Written to_mjcf(const Model& model);

}  // namespace plumbline::exchange
