#pragma once
/// \file
/// An SDF or a URDF, as sdformat's own parser has it, written down as an MJCF: the mechanics that Gazebo is
/// given, at work in MuJoCo.

#include <array>
#include <string>

namespace plumbline::exchange::test {

/// \param end  the link or frame that becomes the site "end"
/// \param gravity  where the file has no world
std::string mjcf_of(const std::string& file, const std::string& end, std::array<double, 3> gravity);

}  // namespace plumbline::exchange::test
