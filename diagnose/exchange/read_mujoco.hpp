#pragma once
/// \file
/// MJCF and URDF, read by MuJoCo's own parser.

#include <string>

#include "diagnose/exchange/planar_chain.hpp"

namespace plumbline::exchange {

/// \param file  of MJCF or URDF, with the files that it includes beside it
/// \throws Error with the parser's reason, or where the program was built without MuJoCo
ReadModel read_mujoco(const std::string& file);

}  // namespace plumbline::exchange
