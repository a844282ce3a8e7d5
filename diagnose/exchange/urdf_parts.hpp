#pragma once
/// \file
/// The elements of URDF that a tree is written with.

#include <Eigen/Core>

#include "diagnose/exchange/tree.hpp"
#include "diagnose/exchange/xml.hpp"

namespace plumbline::exchange {

/// \param turning  moment of inertia
Xml urdf_inertial(double mass, Pair middle, double turning);
Xml urdf_link(const Body& one);
/// How the link hangs on its parent, in the frame of that.
Xml urdf_joint(const Body& one);
/// The same at another place, moving along or about another axis.
Xml urdf_joint(const Body& one, const Eigen::Vector3d& place, const Eigen::Vector3d& axis);
/// The spring of a joint, as Gazebo reads it.
Xml urdf_spring(const Hinge& hinge);

}  // namespace plumbline::exchange
