#pragma once
/// \file
/// What a body of an MJCF weighs.

#include "diagnose/exchange/mjcf_scene.hpp"

namespace plumbline::exchange {

struct MjcfMass {
  double mass = 0;                                   ///< kg
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< centre of mass, in the body
  std::size_t unknown = 0;                           ///< meshes whose mass is that of a file
};

/// Of its <inertial>, or of its geoms, as <compiler inertiafromgeom> says.
MjcfMass mass_of(pugi::xml_node body, const MjcfScene& scene);

}  // namespace plumbline::exchange
