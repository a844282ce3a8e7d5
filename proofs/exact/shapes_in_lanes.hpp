#pragma once
/// \file
/// Mode shapes by runs from both ends (<plumbline/straight/buckling_mode.hpp>) in sums of two doubles, eight
/// modes at once.

#include <optional>
#include <string>

#include "proofs/exact/forces_in_lanes.hpp"

namespace plumbline::proofs {

/// The joint angles of a mode, the largest 1 or -1, the first that is not zero positive, each the double that
/// is nearest; and the lateral force at these angles.
struct ShapeInLanes {
  std::vector<double> q;
  std::string signs;  ///< of the angles, not of what becomes of the smallest ones in double
  Rational fy;
};

/// The shapes at forces that forces_in_lanes() gave. How much rounding matters, the same runs in doubles
/// show: two doubles are 2^-51 as coarse, and taken to be 2^-38. Nothing for a mode where that leaves the
/// last bit of an angle open, or whether a joint turns at all.
std::vector<std::optional<ShapeInLanes>> shapes_in_lanes(const StraightChain<Rational>& chain,
                                                         const std::vector<ForceInLanes>& forces);

}  // namespace plumbline::proofs
