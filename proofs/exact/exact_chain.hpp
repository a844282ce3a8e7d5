#pragma once
/// \file
/// The buckling modes of one rational chain in exact arithmetic, by three independent ways: the determinant
/// of the paper's matrices, the closed form, and the recursion (proofs/theorems.md).
///
/// Any n, unequal links, one passive joint anywhere. Every function throws Error for n = 1 (no mode) and for
/// two passive joints (det B = 0).

#include <cstddef>
#include <plumbline/chain/chain.hpp>

#include "proofs/exact/polynomial.hpp"

namespace plumbline::proofs {

/// D(F) = det(A F + B) from the determinant itself. Its n - 1 roots are the critical forces.
Polynomial bordered_determinant(const Chain<Rational>& chain);

/// D(F) by theorem "Closed form".
Polynomial closed_form(const Chain<Rational>& chain);

/// D(F) by theorem "Recursion", in the form that needs no special case at a passive joint.
Polynomial recursion_polynomial(const Chain<Rational>& chain);

/// The characteristic polynomial det(lambda I - B^-1 A) = det(lambda B - A) / det B, of degree n + 1.
Polynomial characteristic_polynomial(const Chain<Rational>& chain);

Rational determinant_of_A(const Chain<Rational>& chain);
Rational determinant_of_B(const Chain<Rational>& chain);
std::size_t rank_of_BinvA(const Chain<Rational>& chain);

/// Of the eigenvalue zero of B^-1 A.
struct Multiplicity {
  std::size_t algebraic, geometric;
};
Multiplicity multiplicity_of_zero_eigenvalue(const Chain<Rational>& chain);

/// The number of distinct critical forces: n - 1, unless an interior passive joint makes some coincide.
std::size_t distinct_critical_forces(const Chain<Rational>& chain);

/// F_1 + … + F_{n-1}.
Rational sum_of_forces(const Chain<Rational>& chain);
/// 1/F_1 + … + 1/F_{n-1}: minus the sum of the eigenvalues of B^-1 A.
Rational sum_of_inverse_forces(const Chain<Rational>& chain);
/// F_1 … F_{n-1}.
Rational product_of_forces(const Chain<Rational>& chain);

}  // namespace plumbline::proofs
