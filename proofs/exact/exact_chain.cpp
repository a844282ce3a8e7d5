#include "proofs/exact/exact_chain.hpp"

#include <plumbline/straight/algorithm1.hpp>

#include "proofs/exact/exact_matrix.hpp"

namespace plumbline::proofs {
namespace {

/// sum += factor x^power p
void accumulate(Polynomial& sum, const Rational& factor, const Polynomial& p, std::size_t power = 0) {
  if (sum.size() < p.size() + power) sum.resize(p.size() + power, Rational(0));
  for (std::size_t i = 0; i < p.size(); ++i) sum[i + power] += factor * p[i];
}

}  // namespace

Polynomial bordered_determinant(const Chain<Rational>& chain) {
  mode_count(chain);
  return pencil_determinant(matrix_B(chain), matrix_A(chain));
}

// The sum over index sets, gathered by their least index i: from_index[i] holds the terms of the sets with
// that least index, without the factor z_i and the stiffnesses before i.
Polynomial closed_form(const Chain<Rational>& chain) {
  mode_count(chain);
  const std::size_t n = chain.size();
  const std::vector<Rational> z = distance_to_end(chain);
  std::vector<Polynomial> from_index(n);
  for (std::size_t i = n; i-- > 0;) {
    Rational between = 1;  // the stiffnesses after i and before j
    for (std::size_t j = i + 1; j < n; ++j) {
      accumulate(from_index[i], -(z[i] - z[j]) * between, from_index[j], 1);
      between *= chain.stiffness()[j];
    }
    accumulate(from_index[i], -z[i] * between, {1});
  }
  Polynomial sum;
  Rational before = 1;
  for (std::size_t i = 0; i < n; ++i) {
    accumulate(sum, z[i] * before, from_index[i]);
    before *= chain.stiffness()[i];
  }
  return trimmed(std::move(sum));
}

// H_i = z_1^2 k_2 … k_i h_i and G_i = z_1^2 k_2 … k_{i-1} g_i (G_1 = 1) stay finite where a stiffness is
// zero.
Polynomial recursion_polynomial(const Chain<Rational>& chain) {
  mode_count(chain);
  const std::vector<Rational> z = distance_to_end(chain);
  Polynomial H{z[0] * z[0]}, G{1};
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    Polynomial next_G, next_H;
    accumulate(next_G, chain.stiffness()[i], G);
    accumulate(next_G, -chain.length()[i] / (z[i] * z[i + 1]), H, 1);
    accumulate(next_H, chain.stiffness()[i + 1], H);
    accumulate(next_H, z[i + 1] * z[i + 1], next_G);
    G = std::move(next_G);
    H = std::move(next_H);
  }
  Polynomial D;
  accumulate(D, -1, H);
  return trimmed(std::move(D));
}

Polynomial characteristic_polynomial(const Chain<Rational>& chain) {
  Polynomial p = pencil_determinant(-matrix_A(chain), matrix_B(chain));
  const Rational det_B = determinant_of_B(chain);
  for (Rational& c : p) c /= det_B;
  return p;
}

Rational determinant_of_A(const Chain<Rational>& chain) {
  mode_count(chain);
  return determinant(matrix_A(chain));
}

Rational determinant_of_B(const Chain<Rational>& chain) {
  mode_count(chain);
  return determinant(matrix_B(chain));
}

std::size_t rank_of_BinvA(const Chain<Rational>& chain) {
  return rank(algorithm1_matrix(chain));
}

Multiplicity multiplicity_of_zero_eigenvalue(const Chain<Rational>& chain) {
  return {multiplicity_of_zero(characteristic_polynomial(chain)), chain.size() + 1 - rank_of_BinvA(chain)};
}

std::size_t distinct_critical_forces(const Chain<Rational>& chain) {
  return distinct_positive_roots(recursion_polynomial(chain));
}

Rational sum_of_forces(const Chain<Rational>& chain) {
  const Polynomial D = closed_form(chain);
  return -D[D.size() - 2] / D.back();
}

Rational sum_of_inverse_forces(const Chain<Rational>& chain) {
  const Polynomial D = closed_form(chain);
  return -D[1] / D[0];
}

Rational product_of_forces(const Chain<Rational>& chain) {
  const Polynomial D = closed_form(chain);
  return mode_count(chain) % 2 == 0 ? Rational(D[0] / D.back()) : Rational(-D[0] / D.back());
}

}  // namespace plumbline::proofs
