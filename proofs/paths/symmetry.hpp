#pragma once
/// \file
/// Symmetries of a loaded chain that make bifurcations.

#include <plumbline/chain/chain.hpp>
#include <plumbline/loaded/loading.hpp>
#include <vector>

namespace plumbline::proofs {

/// A map of shapes and forces that takes equilibria to equilibria at the same load: link directions are read
/// in reverse order (theorem "Reversal"), or change their signs together with the lateral force, or both.
struct Symmetry {
  bool reversed, mirrored;
};

/// Those that the chain has exactly. A chain that lacks one by however little has none.
/// \param direction  of the load
std::vector<Symmetry> symmetries(const Chain<Rational>& chain, Control control,
                                 const Point<Rational>& direction);

}  // namespace plumbline::proofs
