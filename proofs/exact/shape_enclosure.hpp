#pragma once
/// \file
/// Mode shapes of an exact chain to certified digits.

#include <optional>
#include <string>

#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/exact_count.hpp"

namespace plumbline::proofs {

/// A buckling mode as decimals, one a joint: each is within one unit in its last digit of the true angle, a
/// "0" within one unit in that place behind the point. The largest angle is 1 by normalisation and written
/// "1".
struct ShapeEnclosure {
  ChainPart part;  ///< the joints that turn
  int digits;
  std::vector<std::string> q;
};

/// The shape, to so many digits (two or more), of the one mode of a part that buckles between two forces;
/// nothing where these bounds are too wide for that. A recursion in intervals over all forces between the
/// bounds.
std::optional<ShapeEnclosure> enclose_shape(const StraightChain<Rational>& chain, const ChainPart& part,
                                            const Rational& low, const Rational& high, int digits);

}  // namespace plumbline::proofs
