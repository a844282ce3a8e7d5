#pragma once
/// \file
/// Numbers of a model's file that no body can have, or no angle in radians.

#include <Eigen/Core>
#include <string>

namespace plumbline::exchange {

/// \throws Error at the place where the mass is negative
void require_mass(double mass, const std::string& place);

/// What no body has among moments of inertia: a negative one, or one larger than the two others together.
/// Files in use are full of such, and statics knows no inertia: words for a note, or none.
/// \param inertia  about the centre of mass, kg m²
std::string impossible_inertia(const Eigen::Matrix3d& inertia);

/// Angles beyond two turns, as people write degrees.
/// \throws Error at the place where they are
void require_radians(const Eigen::Vector3d& angles, const std::string& place);

}  // namespace plumbline::exchange
