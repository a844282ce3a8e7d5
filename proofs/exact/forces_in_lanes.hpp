#pragma once
/// \file
/// Critical forces to the digits of two doubles (string_in_lanes.hpp): good enough to say where to count, and
/// to begin from with more digits.

#include <plumbline/straight/straight_chain.hpp>

#include "proofs/exact/string_in_lanes.hpp"

namespace plumbline::proofs {

/// A critical force, and which one of which part of the chain (exact_count.hpp) it is, both from 0.
struct ForceInLanes {
  Wide value;
  std::size_t part, index;
};

/// The lowest critical forces, ascending: so many, or all. None where the chain leaves the range of double.
/// \throws Error for n = 1 or a mechanism
std::vector<ForceInLanes> forces_in_lanes(const StraightChain<Rational>& chain, std::size_t lowest);

/// Significant digits that they have, nearly always, at the end of a string of a million beads.
constexpr int lane_digits = 28;
/// From so many links on lanes are worth their while.
constexpr std::size_t long_chain = 16;

}  // namespace plumbline::proofs
