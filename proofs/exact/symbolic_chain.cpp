#include "proofs/exact/symbolic_chain.hpp"

#include <algorithm>
#include <numeric>
#include <plumbline/base/error.hpp>
#include <stdexcept>
#include <string>

namespace plumbline::proofs {
namespace {

using GiNaC::ex;
using GiNaC::matrix;

unsigned order(const SymbolicChain& chain) {
  return static_cast<unsigned>(chain.size());
}

std::vector<ex> symbols(const std::string& letter, std::size_t n) {
  std::vector<ex> result;
  for (std::size_t i = 1; i <= n; ++i) result.push_back(GiNaC::possymbol(letter + std::to_string(i)));
  return result;
}

/// det B, or an Error.
ex nonzero_det_B(const SymbolicChain& chain) {
  ex det = expanded_determinant(matrix_B(chain));
  if (det.is_zero()) throw Error("stiffness", "det B = 0", "at most one passive joint");
  return det;
}

/// One solution x of A x = rhs, its free variables set to `free`; none where the system has no solution.
std::vector<matrix> solve(const matrix& A, const matrix& rhs, const ex& free) {
  matrix x(A.cols(), 1);
  for (unsigned i = 0; i < A.cols(); ++i) x(i, 0) = GiNaC::symbol("x");
  try {
    const matrix general = A.solve(x, rhs);
    GiNaC::exmap choice;
    for (unsigned i = 0; i < A.cols(); ++i) choice[x(i, 0)] = free;
    return {GiNaC::ex_to<matrix>(general.subs(choice))};
  } catch (const std::runtime_error&) {  // GiNaC's answer to an inconsistent system
    return {};
  }
}

}  // namespace

SymbolicChain SymbolicChain::generic(std::size_t n) {
  return {symbols("L", n), symbols("k", n)};
}

std::vector<ex> SymbolicChain::distance_to_end() const {
  std::vector<ex> z(size() + 1, 0);
  for (std::size_t i = size(); i-- > 0;) z[i] = z[i + 1] + length[i];
  return z;
}

matrix matrix_S0(const SymbolicChain& chain) {
  const std::vector<ex> z = chain.distance_to_end();
  matrix S0(order(chain), 1);
  for (unsigned i = 0; i < S0.rows(); ++i) S0(i, 0) = z[i];
  return S0;
}

matrix matrix_S1(const SymbolicChain& chain) {
  const std::vector<ex> z = chain.distance_to_end();
  matrix S1(order(chain), order(chain));
  for (unsigned i = 0; i < S1.rows(); ++i) {
    for (unsigned j = 0; j < S1.cols(); ++j) S1(i, j) = -z[std::max(i, j)];
  }
  return S1;
}

matrix matrix_A(const SymbolicChain& chain) {
  const unsigned n = order(chain);
  const matrix S1 = matrix_S1(chain);
  matrix A(n + 1, n + 1);
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) A(i, j) = S1(i, j);
  }
  return A;
}

matrix matrix_B(const SymbolicChain& chain) {
  const unsigned n = order(chain);
  const matrix S0 = matrix_S0(chain);
  matrix B(n + 1, n + 1);
  for (unsigned i = 0; i < n; ++i) {
    B(i, i) = chain.stiffness[i];
    B(i, n) = B(n, i) = S0(i, 0);
  }
  return B;
}

ex expanded_determinant(const matrix& matrix) {
  return matrix.determinant(GiNaC::determinant_algo::laplace).expand();
}

ex bordered_determinant(const SymbolicChain& chain, const ex& F) {
  return expanded_determinant(matrix_A(chain).mul_scalar(F).add(matrix_B(chain)));
}

ex closed_form_coefficient(const SymbolicChain& chain, std::size_t m) {
  const std::size_t n = chain.size();
  const std::vector<ex> z = chain.distance_to_end();
  std::vector<bool> chosen(n, false);
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(m), true);
  ex sum = 0;
  do {
    ex term = 1;
    std::size_t next = n;  // the chosen index behind i, where z is 0 at the end
    for (std::size_t i = n; i-- > 0;) {
      term *= chosen[i] ? z[i] - z[next] : chain.stiffness[i];
      if (chosen[i]) next = i;
    }
    sum += (z[next] * term).expand();
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return sum;
}

ex characteristic_numerator(const SymbolicChain& chain, const ex& lambda) {
  return expanded_determinant(matrix_B(chain).mul_scalar(lambda).sub(matrix_A(chain)));
}

ex characteristic_polynomial(const SymbolicChain& chain, const ex& lambda) {
  const ex det = nonzero_det_B(chain);
  const ex numerator = characteristic_numerator(chain, lambda);
  ex sum = 0;
  for (int power = 0; power <= static_cast<int>(chain.size()) + 1; ++power)
    sum += numerator.coeff(lambda, power) / det * pow(lambda, power);
  return sum;
}

std::size_t rank_of_BinvA(const SymbolicChain& chain) {
  nonzero_det_B(chain);  // so that B^-1 A has the rank of A
  return matrix_A(chain).rank();
}

ZeroEigenvalue zero_eigenvalue(const SymbolicChain& chain) {
  const GiNaC::symbol lambda("lambda");
  const matrix A = matrix_A(chain);
  const matrix B = matrix_B(chain);
  ZeroEigenvalue zero{};
  zero.geometric = chain.size() + 1 - rank_of_BinvA(chain);
  zero.algebraic = static_cast<std::size_t>(characteristic_numerator(chain, lambda).ldegree(lambda));
  auto next = solve(A, matrix(A.rows(), 1), 1);
  while (!next.empty() && zero.jordan_chain.size() < A.rows()) {
    zero.jordan_chain.push_back(next.front());
    next = solve(A, B.mul(next.front()), 0);  // B^-1 A x = v
  }
  return zero;
}

ex energy_factor(const SymbolicChain& chain, const std::vector<ex>& q) {
  ex energy = 0;
  ex shortening = 0;
  ex theta = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    theta += q[i];
    energy += chain.stiffness[i] * pow(q[i], 2);
    shortening += chain.length[i] * pow(theta, 2);
  }
  return energy / shortening;
}

ex energy_factor_of_mode(std::size_t n, const ex& F) {
  SymbolicChain chain = SymbolicChain::generic(n);
  const ex Fy = GiNaC::symbol("Fy");
  std::vector<ex> q = symbols("q", n);
  const std::vector<ex> z = chain.distance_to_end();
  q[n - 1] = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) q[n - 1] -= z[i] * q[i] / z[n - 1];  // (30)
  const matrix torque = matrix_S1(chain)
                            .mul(matrix(order(chain), 1, GiNaC::lst(q.begin(), q.end())))
                            .mul_scalar(F)
                            .add(matrix_S0(chain).mul_scalar(Fy));
  for (unsigned i = 0; i < n; ++i) chain.stiffness[i] = -torque(i, 0) / q[i];  // (29)
  const ex factor = energy_factor(chain, q);
  const ex scale = pow(z[n - 1], 2);  // both parts of the quotient become polynomials
  ex quotient;
  if (!GiNaC::divide((factor.numer() * scale).expand(), (factor.denom() * scale).expand(), quotient))
    throw Error("energy factor", "a remainder", "a polynomial in F");
  return quotient;
}

}  // namespace plumbline::proofs
