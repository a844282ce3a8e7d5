#pragma once
/// \file
/// Mass and centre of mass of an MJCF body.

#include "diagnose/exchange/mjcf_scene.hpp"

namespace plumbline::exchange {

struct MjcfMass {
  double mass = 0;                                   ///< kg
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< centre of mass, in the body
  std::size_t unknown = 0;                           ///< meshes, whose mass only the mesh file tells
};

/// The mass from <inertial> or from the geoms, according to <compiler inertiafromgeom>.
MjcfMass mass_of(pugi::xml_node body, const MjcfScene& scene);

}  // namespace plumbline::exchange
