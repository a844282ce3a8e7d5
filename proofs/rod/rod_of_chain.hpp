#pragma once
/// \file
/// The rod that a chain of equal bars stands for (core/plumbline/structure/beam.hpp).

#include "proofs/rod/rod.hpp"

namespace plumbline::proofs {

/// Weights of the links, against x.
struct LinkWeights {
  std::vector<Rational> weight;
  bool multiplied = true;  ///< by the load factor
};

/// What the joints of a chain of bars do not tell of its rod.
struct StatedRod {
  Rational EI, bar;                       ///< bending stiffness; length of each bar
  Rational bed = 0;                       ///< whose springs stand at the joints
  std::vector<LinkWeights> weights = {};  ///< halves of which are among the joints' loads
};

/// A rod with what the chain says of ends, supports, bed and loads. The half bar at an end that holds the
/// chain's turning is the rod's own: its stiffness 2 E I / l is taken out of the spring there.
/// \throws Error for masses that are given, since those of the rod are uniform, and for loads across the chain
Rod rod_of_chain(const Structure<Rational>& chain, const StatedRod& stated);

}  // namespace plumbline::proofs
