#pragma once
/// \file
/// Two critical forces that are exactly equal.

#include <optional>

#include "proofs/exact/enclosure.hpp"
#include "proofs/exact/polynomial.hpp"

namespace plumbline::proofs {

/// A proof that critical forces `index` and `index + 1` are equal: the polynomials in F of the two parts of
/// the chain (exact_count.hpp) have a common factor, which changes sign between the bounds.
struct Tie {
  std::size_t index;
  Rational low, high;  ///< bounds of both forces
  Polynomial factor;   ///< the greatest common factor
  std::vector<Polynomial>
      cofactors;  ///< of the parts in order: factor times cofactor is the part's polynomial, 1 at F = 0
};

/// The tie that makes the count pass these bounds in a step of two; nothing when the two forces between them
/// differ, or there is one only. Exact; O(n^2) operations on long fractions.
std::optional<Tie> find_tie(const StraightChain<Rational>& chain, const ForceEnclosure& bounds);

}  // namespace plumbline::proofs
