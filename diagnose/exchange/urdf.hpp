#pragma once
/// \file
/// URDF, with the springs as Gazebo's extension has them.

#include "diagnose/exchange/model.hpp"

namespace plumbline::exchange {

/// The chain in the plane of x and y, joints q1 to qn about z. URDF knows no springs and no gravity: springs
/// stand in <gazebo> elements, gravity in the comment.
Written to_urdf(const Model& model);

}  // namespace plumbline::exchange
