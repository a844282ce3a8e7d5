#pragma once
/// \file
/// Critical forces with bounds, shapes, and what ties them: everything that a certificate says of a chain's
/// modes.

#include "proofs/exact/shape_enclosure.hpp"
#include "proofs/exact/tie.hpp"

namespace plumbline::proofs {

struct CertifiedModes {
  int digits;
  std::vector<ForceEnclosure> forces;  ///< ascending, from the first mode on
  std::vector<ShapeEnclosure> shapes;  ///< of the first so many of them
  std::vector<Tie> ties;               ///< among them
};

/// The lowest `forces` critical forces and `shapes` (not more of them) mode shapes, each to so many
/// significant digits; two or more for shapes. All modes where there are not more. Modes whose shapes are
/// wanted are told apart, however close, unless they are equal; then each part of the chain brings its own
/// shape.
/// \throws Error for n = 1 or a mechanism
CertifiedModes certify(const StraightChain<Rational>& chain, std::size_t forces, std::size_t shapes,
                       int digits);

/// The critical force of a mode, from 1, rounded to the digits that are certified.
std::string certified_force(const CertifiedModes& modes, std::size_t mode);

}  // namespace plumbline::proofs
