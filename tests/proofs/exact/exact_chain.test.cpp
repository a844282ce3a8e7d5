#include "proofs/exact/exact_chain.hpp"

#include <doctest/doctest.h>

#include "tests/proofs/random_chain.hpp"

using namespace plumbline;
using namespace plumbline::proofs;

namespace {

/// lambda^(n+1) D(-1/lambda) / D(0)
Polynomial reversed(const Polynomial& D) {
  Polynomial chi(D.size() + 2, Rational(0));
  for (std::size_t i = 0; i < D.size(); ++i) chi[D.size() + 1 - i] = (i % 2 == 0 ? D[i] : -D[i]) / D[0];
  return chi;
}

}  // namespace

TEST_CASE("determinant, closed form and recursion give one D(F)") {
  check_property("three ways to D(F), on ten chains a case", [] {
    for (int i = 0; i < 10; ++i) {
      const auto chain = random_chain(Passive::any_one, 2, 9);
      const Polynomial D = bordered_determinant(chain);
      RC_ASSERT(D.size() == chain.size());
      RC_ASSERT(closed_form(chain) == D);
      RC_ASSERT(recursion_polynomial(chain) == D);
    }
  });
}

TEST_CASE("D(F) of one chain is not that of the chain reversed or disturbed") {
  const Polynomial D = bordered_determinant(Chain<Rational>({1, 2, 4}, {1, 1, 1}));
  CHECK(closed_form(Chain<Rational>({4, 2, 1}, {1, 1, 1})) != D);
  CHECK(recursion_polynomial(Chain<Rational>({1, 2, 4}, {1, 1, Rational(1001, 1000)})) != D);
}

TEST_CASE("the characteristic polynomial, rank, zeros and signs of the eigenvalues") {
  check_property("eigenvalues of B^-1 A", [] {
    const auto chain = random_chain(Passive::any_one, 2, 7);
    const Polynomial chi = characteristic_polynomial(chain);
    RC_ASSERT(chi == reversed(closed_form(chain)));
    RC_ASSERT(rank_of_BinvA(chain) == chain.size());
    const Multiplicity zero = multiplicity_of_zero_eigenvalue(chain);
    RC_ASSERT(zero.algebraic == 2U);
    RC_ASSERT(zero.geometric == 1U);
    RC_ASSERT(distinct_positive_roots(chi) == 0U);
    RC_ASSERT(distinct_negative_roots(chi) == distinct_critical_forces(chain));
    RC_ASSERT(determinant_of_A(chain) == 0);
    RC_ASSERT(determinant_of_B(chain) == closed_form(chain)[0]);
  });
}

TEST_CASE("sums and products of the modes: two links") {
  // the only mode: F = [k1/L1^2 + k2 (1/L1 + 1/L2)^2] / (1/L1 + 1/L2)
  const Chain<Rational> chain({2, 3}, {5, 7});
  const Rational F = (Rational(5, 4) + 7 * Rational(25, 36)) / Rational(5, 6);
  CHECK(sum_of_forces(chain) == F);
  CHECK(product_of_forces(chain) == F);
  CHECK(sum_of_inverse_forces(chain) == 1 / F);
}

TEST_CASE("sums and products of the modes: equal links on a passive base") {
  // F_m = 4 (k/L) sin^2(m pi / 2n) (theorem "Equal links"): sum 2 (n - 1), product n, in units of k/L;
  // the inverses sum to (n^2 - 1)/6
  for (const std::size_t n : {2U, 3U, 8U, 25U}) {
    CAPTURE(n);
    std::vector<Rational> stiffness(n, Rational(1));
    stiffness[0] = 0;
    const Chain<Rational> chain(std::vector<Rational>(n, Rational(1)), stiffness);
    CHECK(sum_of_forces(chain) == 2 * (n - 1));
    CHECK(product_of_forces(chain) == n);
    CHECK(sum_of_inverse_forces(chain) == Rational(n * n - 1, 6));
    CHECK(distinct_critical_forces(chain) == n - 1);
  }
}

TEST_CASE("an interior passive joint splits the modes in two families, which may share a force") {
  // Joint 2 passive. Below it: one mode, springs k1/z1^2 against the mass 1/z2 - 1/z1. Above it: links 2 and
  // 3 on a passive base.
  const Chain<Rational> split({1, 1, 1}, {6, 0, 1});
  // below: F = (k1/9) / (1/2 - 1/3) = 2 k1/3 = 4; above: F = 2 k3 = 2
  CHECK(distinct_critical_forces(split) == 2);
  CHECK(sum_of_forces(split) == 6);
  CHECK(product_of_forces(split) == 8);
  const Chain<Rational> tied({1, 1, 1}, {3, 0, 1});  // both 2
  CHECK(distinct_critical_forces(tied) == 1);
  CHECK(product_of_forces(tied) == 4);
  CHECK(multiplicity_of_zero_eigenvalue(tied).algebraic == 2);
}

TEST_CASE("no mode and mechanisms are errors, with one line each") {
  const Chain<Rational> single({1}, {1});
  const Chain<Rational> mechanism({1, 1, 1}, {0, 1, 0});
  for (const auto& chain : {single, mechanism}) {
    CHECK_THROWS_AS(bordered_determinant(chain), Error);
    CHECK_THROWS_AS(closed_form(chain), Error);
    CHECK_THROWS_AS(recursion_polynomial(chain), Error);
    CHECK_THROWS_AS(characteristic_polynomial(chain), Error);
    CHECK_THROWS_AS(rank_of_BinvA(chain), Error);
    CHECK_THROWS_AS(distinct_critical_forces(chain), Error);
    CHECK_THROWS_AS(sum_of_forces(chain), Error);
    CHECK_THROWS_AS(determinant_of_A(chain), Error);
  }
}

TEST_CASE("forty links in reasonable time") {
  std::vector<Rational> length, stiffness;
  for (long i = 1; i <= 40; ++i) {
    length.emplace_back(Rational(i % 7 + 1, i % 3 + 1));
    stiffness.emplace_back(Rational(i % 5 + 1, i % 4 + 1));
  }
  const Chain<Rational> chain(length, stiffness);
  const Polynomial D = recursion_polynomial(chain);
  CHECK(bordered_determinant(chain) == D);
  CHECK(closed_form(chain) == D);
  CHECK(distinct_critical_forces(chain) == 39);
}
