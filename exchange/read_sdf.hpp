#pragma once
/// \file
/// SDF, and URDF with Gazebo's springs, read by sdformat's own parser.

#include <string>

#include "exchange/planar_chain.hpp"

namespace plumbline::exchange {

/// \throws Error with the parser's reason, or where there is not one model in the file
ReadModel read_sdf(const std::string& file);

}  // namespace plumbline::exchange
