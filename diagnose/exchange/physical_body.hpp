#pragma once
/// \file
/// Numbers of a model's file that no body can have, or no angle in radians.

#include <Eigen/Core>
#include <string>

namespace plumbline::exchange {

/// \param inertia  about the centre of mass, kg m²; zero where the file has none
/// \throws Error at the place where the mass is negative, or where the moments of inertia are: one of them
///         negative, or one larger than the two others together
void require_inertia(double mass, const Eigen::Matrix3d& inertia, const std::string& place);

/// Angles beyond two turns, as people write degrees.
/// \throws Error at the place where they are
void require_radians(const Eigen::Vector3d& angles, const std::string& place);

}  // namespace plumbline::exchange
