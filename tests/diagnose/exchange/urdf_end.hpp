#pragma once
/// \file
/// The end point of a URDF.

#include <string>

namespace plumbline::exchange {

/// The text of a URDF in which the links that are named as an end, and the joints that hold them, are marked
/// to be kept: what is fixed, or has no mass, sdformat otherwise merges with what carries it, and drops.
/// Text that is no XML comes back as it is.
std::string with_end_kept(const std::string& urdf);

}  // namespace plumbline::exchange
