#pragma once
/// \file
/// SDF, the format of Gazebo; Drake reads it too.

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// A world with the chain in the plane of x and y, joints q1 to qn about z.
Written to_sdf(const Model& model);

}  // namespace plumbline::exchange
