#pragma once
/// \file
/// Critical forces of an exact chain between two fractions, proved by exact counts.

#include <plumbline/straight/straight_chain.hpp>
#include <vector>

namespace plumbline::proofs {

/// low <= F_index < high: the number of critical forces below `low` is less than `index`, that below `high`
/// is not. Anyone can count again: proofs/certificates/certificate-format.md. Where two critical forces are
/// equal, or closer to each other than the digits asked for, both have the same bounds, which the count
/// passes in one step of two.
struct ForceEnclosure {
  std::size_t index;       ///< from 1, the lowest force
  Rational low, high;      ///< short decimals
  std::size_t below_low;   ///< critical forces below `low`
  std::size_t below_high;  ///< critical forces below `high`
};

/// The lowest critical forces (all, when `lowest` is n - 1 or more) to so many significant digits, which must
/// be positive: high - low is below half a unit in the last of them, and `low` and `high` round to the same
/// decimal of that many digits, unless the force lies within 1e-20 units of half-way between two of them.
/// \throws Error for n = 1 or a mechanism
std::vector<ForceEnclosure> enclose_critical_forces(const StraightChain<Rational>& chain, std::size_t lowest,
                                                    int digits);

}  // namespace plumbline::proofs
