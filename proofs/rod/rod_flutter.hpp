#pragma once
/// \file
/// Where a rod under loads that follow its tangent loses its stability, between two fractions.
///
/// Its small motion m w_tt + (E I w'')'' + ... = 0 has squares x of circular frequencies, the zeros of the
/// characteristic function. Those below a bound are followed on the real line while the factor grows from 0:
/// on each interval of factors they are simple, and their number stays the same, so that none of them leaves
/// the real line. They do so where one of them is zero (divergence) or two meet (flutter).

#include "proofs/exact/follower.hpp"
#include "proofs/exact/real_roots.hpp"
#include "proofs/rod/rod.hpp"

namespace plumbline::proofs {

/// Proved: the lowest so many of the real frequencies are real, distinct and not zero at every smaller
/// factor. Those above them were not followed. Loads with an energy need none to be followed.
struct RodLoss {
  Motion kind;
  NarrowBracket factor;
  std::size_t frequencies;
};

/// \throws Error where no loss is proved
RodLoss rod_flutter(const DividedRod& rod, int digits);

}  // namespace plumbline::proofs
