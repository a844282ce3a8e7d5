#include "proofs/exact/symbolic_chain.hpp"

#include <doctest/doctest.h>

#include <plumbline/chain/linearised.hpp>

using namespace plumbline;
using namespace plumbline::proofs;
using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::symbol;

namespace {

/// -E_1 + E_2 F - E_3 F^2 + …
ex closed_form_of_D(const SymbolicChain& chain, const ex& F) {
  ex sum = 0;
  for (std::size_t m = 1; m <= chain.size(); ++m)
    sum -= closed_form_coefficient(chain, m) * pow(-F, static_cast<int>(m) - 1);
  return sum;
}

ex product(const std::vector<ex>& factors) {
  ex result = 1;
  for (const ex& factor : factors) result *= factor;
  return result;
}

bool vanishes(const matrix& m) {
  for (unsigned i = 0; i < m.rows() * m.cols(); ++i) {
    if (!m.op(i).expand().is_zero()) return false;
  }
  return true;
}

/// Four links of length 1, four stiffnesses of 1, as in (40).
const SymbolicChain unit{{1, 1, 1, 1}, {1, 1, 1, 1}};

}  // namespace

TEST_CASE("the symbolic matrices are those of the core") {
  const Chain<Rational> numbers({Rational(2, 3), 5, Rational(7, 2)}, {0, Rational(3, 4), 11});
  SymbolicChain chain;
  for (std::size_t i = 0; i < 3; ++i) {
    chain.length.emplace_back(ex(numbers.length()[i].str(), GiNaC::lst{}));
    chain.stiffness.emplace_back(ex(numbers.stiffness()[i].str(), GiNaC::lst{}));
  }
  const auto same = [](const matrix& ours, const Matrix<Rational>& core) {
    for (unsigned i = 0; i < ours.rows(); ++i) {
      for (unsigned j = 0; j < ours.cols(); ++j) {
        if (!(ours(i, j) - ex(core(i, j).str(), GiNaC::lst{})).is_zero()) return false;
      }
    }
    return ours.rows() == core.rows() && ours.cols() == core.cols();
  };
  CHECK(same(matrix_S0(chain), matrix_S0(numbers)));
  CHECK(same(matrix_S1(chain), matrix_S1(numbers)));
  CHECK(same(matrix_A(chain), matrix_A(numbers)));
  CHECK(same(matrix_B(chain), matrix_B(numbers)));
  CHECK_FALSE(same(matrix_A(chain), matrix_B(numbers)));
}

TEST_CASE("D(F) is its closed form for n = 1 … 6, and no neighbour of it") {
  const symbol F("F");
  for (std::size_t n = 1; n <= 6; ++n) {
    CAPTURE(n);
    const auto chain = SymbolicChain::generic(n);
    const ex D = bordered_determinant(chain, F);
    CHECK((D - closed_form_of_D(chain, F)).expand().is_zero());
    CHECK_FALSE((D + closed_form_of_D(chain, F)).expand().is_zero());
    if (n > 1) CHECK_FALSE((D - closed_form_of_D(chain, -F)).expand().is_zero());
    CHECK(D.degree(F) == static_cast<int>(n) - 1);
  }
}

TEST_CASE("det A vanishes, det S1 = (-1)^n L_1 … L_n does not") {
  for (std::size_t n = 2; n <= 6; ++n) {
    CAPTURE(n);
    const auto chain = SymbolicChain::generic(n);
    CHECK(expanded_determinant(matrix_A(chain)).is_zero());
    const ex det_S1 = expanded_determinant(matrix_S1(chain));
    CHECK((det_S1 - (n % 2 == 0 ? 1 : -1) * product(chain.length)).is_zero());
    CHECK((expanded_determinant(matrix_B(chain)) + closed_form_coefficient(chain, 1)).expand().is_zero());
  }
}

TEST_CASE("the characteristic polynomial has the coefficients E_m / E_1, and none below lambda^2") {
  const symbol lambda("lambda");
  for (std::size_t n = 2; n <= 6; ++n) {
    CAPTURE(n);
    const auto chain = SymbolicChain::generic(n);
    const ex numerator = characteristic_numerator(chain, lambda);
    CHECK(numerator.coeff(lambda, 0).is_zero());
    CHECK(numerator.coeff(lambda, 1).is_zero());
    for (std::size_t m = 1; m <= n; ++m) {
      const ex coefficient = numerator.coeff(lambda, static_cast<int>(n + 2 - m));
      CHECK((coefficient + closed_form_coefficient(chain, m)).expand().is_zero());
      CHECK_FALSE((coefficient - closed_form_coefficient(chain, m)).expand().is_zero());
    }
  }
}

TEST_CASE("the characteristic polynomial of the unit chain of four links, exactly") {
  const symbol lambda("lambda");
  const ex chi = characteristic_polynomial(unit, lambda);
  const ex true_one =
      pow(lambda, 5) + ex(9) / 5 * pow(lambda, 4) + ex(9) / 10 * pow(lambda, 3) + ex(2) / 15 * pow(lambda, 2);
  CHECK((chi - true_one).expand().is_zero());
  CHECK_FALSE((chi - true_one + pow(lambda, 2) / 150).expand().is_zero());
}

TEST_CASE("B^-1 A has rank n, not n - 1, and one Jordan block of size 2 for the eigenvalue zero") {
  for (std::size_t n = 2; n <= 6; ++n) {
    CAPTURE(n);
    const auto chain = SymbolicChain::generic(n);
    CHECK(rank_of_BinvA(chain) == n);
    const ZeroEigenvalue zero = zero_eigenvalue(chain);
    CHECK(zero.algebraic == 2);
    CHECK(zero.geometric == 1);
    REQUIRE(zero.jordan_chain.size() == 2);
    const matrix& first = zero.jordan_chain[0];
    const matrix& second = zero.jordan_chain[1];
    CHECK(vanishes(matrix_A(chain).mul(first)));
    CHECK(vanishes(matrix_A(chain).mul(second).sub(matrix_B(chain).mul(first))));
    CHECK_FALSE(vanishes(matrix_A(chain).mul(second)));
    matrix unit_last(static_cast<unsigned>(n) + 1, 1), minus_unit_first(static_cast<unsigned>(n) + 1, 1);
    unit_last(static_cast<unsigned>(n), 0) = 1;
    minus_unit_first(0, 0) = -1;
    CHECK(vanishes(first.sub(unit_last)));
    CHECK(vanishes(second.sub(minus_unit_first)));
  }
}

TEST_CASE("two passive joints are refused, one is not") {
  const symbol lambda("lambda");
  const SymbolicChain one{{1, 1, 1}, {1, 0, 1}};
  const SymbolicChain two{{1, 1, 1}, {0, 1, 0}};
  CHECK(rank_of_BinvA(one) == 3);
  CHECK_THROWS_AS(rank_of_BinvA(two), Error);
  CHECK_THROWS_AS(zero_eigenvalue(two), Error);
  CHECK_THROWS_AS(characteristic_polynomial(two, lambda), Error);
}

TEST_CASE("the energy factor of every mode is its force") {
  const symbol F("F");
  for (std::size_t n = 2; n <= 6; ++n) {
    CAPTURE(n);
    CHECK((energy_factor_of_mode(n, F) - F).is_zero());
    CHECK_FALSE((energy_factor_of_mode(n, F) - 2 * F).is_zero());
    CHECK_FALSE((energy_factor_of_mode(n, F) + F).is_zero());
  }
}

TEST_CASE("the energy factor of the two-link mode") {
  const auto chain = SymbolicChain::generic(2);
  const ex L1 = chain.length[0], L2 = chain.length[1], k1 = chain.stiffness[0], k2 = chain.stiffness[1];
  const ex slope_difference = 1 / L1 + 1 / L2;
  const ex F = (k1 / pow(L1, 2) + k2 * pow(slope_difference, 2)) / slope_difference;
  CHECK((energy_factor(chain, {1 / L1, -slope_difference}) - F).normal().is_zero());
  CHECK((bordered_determinant(chain, F)).normal().is_zero());
  CHECK_FALSE((bordered_determinant(chain, F + k1)).normal().is_zero());
}
