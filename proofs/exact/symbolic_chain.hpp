#pragma once
/// \file
/// The linearised straight chain, paper equations (28) to (39), in symbols: determinants, the characteristic
/// polynomial of B^-1 A and its closed form, rank, the structure of the zero eigenvalue, the energy factor.
///
/// Every function computes and returns what came out; none of them judges. What holds for all n is proved in
/// proofs/theorems.md. GiNaC is not thread-safe: use it from one thread.

#include <ginac/ginac.h>

#include <cstddef>
#include <vector>

namespace plumbline::proofs {

/// Lengths L_1 … L_n and joint stiffnesses k_1 … k_n, each a symbol, a number or any other expression.
struct SymbolicChain {
  std::vector<GiNaC::ex> length, stiffness;

  /// A chain of n links with positive symbols L1 … Ln, k1 … kn of its own.
  static SymbolicChain generic(std::size_t n);

  [[nodiscard]] std::size_t size() const { return length.size(); }
  /// z_i = L_i + … + L_n for i = 1 … n, and 0 behind it.
  [[nodiscard]] std::vector<GiNaC::ex> distance_to_end() const;
};

/// S0 of (28), n x 1.
GiNaC::matrix matrix_S0(const SymbolicChain& chain);
/// S1 of (28), n x n.
GiNaC::matrix matrix_S1(const SymbolicChain& chain);
/// A of (33), (n+1) x (n+1).
GiNaC::matrix matrix_A(const SymbolicChain& chain);
/// B of (33), (n+1) x (n+1).
GiNaC::matrix matrix_B(const SymbolicChain& chain);

/// The determinant of a square matrix, expanded; by minors, which needs no division.
GiNaC::ex expanded_determinant(const GiNaC::matrix& matrix);

/// D(F) = det(A F + B), expanded: its roots in F are the critical forces.
GiNaC::ex bordered_determinant(const SymbolicChain& chain, const GiNaC::ex& F);

/// E_m, the sum over all index sets i_1 < … < i_m of z_{i_1} (z_{i_1} - z_{i_2}) … (z_{i_m} - 0) times the
/// stiffnesses outside the set (theorem "Closed form"). It is positive, E_1 = -det B, and
/// D(F) = -E_1 + E_2 F - E_3 F^2 + … up to F^(n-1).
/// \param m from 1 to n
GiNaC::ex closed_form_coefficient(const SymbolicChain& chain, std::size_t m);

/// det(lambda B - A), expanded: det B times the characteristic polynomial of B^-1 A.
GiNaC::ex characteristic_numerator(const SymbolicChain& chain, const GiNaC::ex& lambda);

/// The characteristic polynomial det(lambda I - B^-1 A), collected in lambda, which must be a symbol. Its
/// coefficients are quotients by det B, not cancelled.
/// \throws Error where det B vanishes identically
GiNaC::ex characteristic_polynomial(const SymbolicChain& chain, const GiNaC::ex& lambda);

/// The rank of B^-1 A for generic values of the symbols.
/// \throws Error where det B vanishes identically
std::size_t rank_of_BinvA(const SymbolicChain& chain);

/// The eigenvalue zero of B^-1 A.
struct ZeroEigenvalue {
  std::size_t algebraic;  ///< its multiplicity as a root of the characteristic polynomial
  std::size_t geometric;  ///< the number of independent eigenvectors
  /// v_1, v_2, … with B^-1 A v_1 = 0 and B^-1 A v_{i+1} = v_i, as long as there is a next one
  std::vector<GiNaC::matrix> jordan_chain;
};

/// Computed for generic values of the symbols.
/// \throws Error where det B vanishes identically
ZeroEigenvalue zero_eigenvalue(const SymbolicChain& chain);

/// The energy factor (39) of the joint angles q: sum k_i q_i^2 over sum L_j theta_j^2.
GiNaC::ex energy_factor(const SymbolicChain& chain, const std::vector<GiNaC::ex>& q);

/// The energy factor (39) of a mode (q, F_y) with the force F, where the equations of the mode, (29) and
/// (30), have eliminated the stiffnesses and q_n: what it is for every mode of every chain of n links.
/// \param
/// F a symbol
/// \throws Error where the elimination leaves no polynomial in F and the free variables
GiNaC::ex energy_factor_of_mode(std::size_t n, const GiNaC::ex& F);

}  // namespace plumbline::proofs
