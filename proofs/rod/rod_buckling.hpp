#pragma once
/// \file
/// The lowest critical factor of a rod under loads that have an energy, between two fractions.

#include "proofs/exact/real_roots.hpp"
#include "proofs/rod/rod.hpp"

namespace plumbline::proofs {

/// The factor at which the rod's energy ceases to be positive: no negative direction at `low`, one or more at
/// `high`, both proved. Loads are taken as dead ones.
/// \throws Error for a rod that is not stable at factor 0 or that no factor makes give way, and where 64 digits
///         do not suffice
NarrowBracket rod_buckling(const DividedRod& rod, int digits);

}  // namespace plumbline::proofs
