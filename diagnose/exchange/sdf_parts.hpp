#pragma once
/// \file
/// The elements of SDF that a tree is written with.

#include <Eigen/Core>
#include <string>

#include "diagnose/exchange/tree.hpp"
#include "diagnose/exchange/xml.hpp"

namespace plumbline::exchange {

/// \param relative_to  the frame that the place is in; empty for that of the model
Xml sdf_link(const Body& one, const Eigen::Vector3d& place, const std::string& relative_to);
/// How the link hangs on its parent.
/// \param axis  in its own frame
Xml sdf_joint(const Body& one, const Eigen::Vector3d& axis);
/// The range of a joint, which yields by its stiffness.
Xml sdf_limit(const Hinge& hinge, Pair range);

}  // namespace plumbline::exchange
