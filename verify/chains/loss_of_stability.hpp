#pragma once
/// \file
/// Where the straight line of a stated chain, or of the rod that it stands for, loses its stability as its
/// loads grow.

#include <string>

#include "statement/plane.hpp"

namespace plumbline::verify {

struct LossOfStability {
  std::string kind;    ///< "buckling", and of a load that follows "flutter" or "divergence"
  Rational low, high;  ///< of the load factor; stable from 0 up to `low`, not at `high`
};

/// To ten digits. \throws Error where it cannot be enclosed, or an earlier one is not excluded
LossOfStability loss_of_stability(const Structure<Rational>& structure);
/// Of the rod of the key `beam`, to ten digits. \throws Error where the chain states none
LossOfStability loss_of_rod(const statement::PlaneChain& chain);

}  // namespace plumbline::verify
