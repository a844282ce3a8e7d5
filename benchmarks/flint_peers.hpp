#pragma once
/// \file
/// Critical forces to many digits by FLINT and Arb, which prove what they enclose.

#include <memory>
#include <plumbline/chain/chain.hpp>
#include <string>
#include <vector>

namespace plumbline::bench {

/// All critical forces of a chain, ascending, each in a ball of Arb that holds no other.
class Balls {
 public:
  explicit Balls(std::size_t count);

  [[nodiscard]] std::vector<double> middles() const;
  /// Whether every radius is below half a unit of the last of so many digits.
  [[nodiscard]] bool reach(int digits) const;
  /// Whether each ball meets what rounds to the decimal of so many digits.
  [[nodiscard]] bool agree(const std::vector<std::string>& decimals, int digits) const;

  struct Data;  ///< of Arb
  [[nodiscard]] Data& data() const { return *data_; }

 private:
  std::shared_ptr<Data> data_;
};

/// Of a chain without passive joints; `guard`: bits of working precision beyond the digits.
using FlintPeer = Balls (*)(const Chain<Rational>& chain, int digits, long guard);

/// All roots of D(F) in integers, by arb_fmpz_poly_complex_roots, which chooses its precision itself.
Balls polynomial_roots(const Chain<Rational>& chain, int digits, long guard);
/// The same to `guard` bits, which isolate them, and from there Newton's method of arb_poly, with its proof.
Balls refined_roots(const Chain<Rational>& chain, int digits, long guard);
/// Eigenvalues of the string's tridiagonal matrix: acb_mat_approx_eig_qr, then acb_mat_eig_simple.
Balls matrix_eigenvalues(const Chain<Rational>& chain, int digits, long guard);

}  // namespace plumbline::bench
