#pragma once
/// \file
/// SDF, and URDF with Gazebo's springs, read by sdformat's own parser.

#include <string>

#include <map>
#include <string>

#include "diagnose/exchange/planar_chain.hpp"

namespace plumbline::exchange {

/// \throws Error with the parser's reason, or where there is not one model in the file
ReadModel read_sdf(const std::string& file);

/// How links, joints and frames of a model are turned in its frame, by name.
std::map<std::string, Eigen::Matrix3d> sdf_rotations(const std::string& file);

}  // namespace plumbline::exchange
