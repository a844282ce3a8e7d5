#pragma once
/// \file
/// Polynomials in one variable with exact rational coefficients, as far as the chain needs them.

#include <cstddef>
#include <plumbline/base/number.hpp>
#include <vector>

namespace plumbline::proofs {

/// Coefficients in ascending powers, without zeros at the end; the zero polynomial is empty.
using Polynomial = std::vector<Rational>;

/// p without the zeros behind its last non-zero coefficient.
Polynomial trimmed(Polynomial p);

Rational evaluate(const Polynomial& p, const Rational& x);

/// The polynomial of degree below values.size() with p(0), p(1), p(2), … as given.
Polynomial interpolate(const std::vector<Rational>& values);

/// The number of zeros at 0, with multiplicity: the power of the lowest term.
/// \throws Error for p = 0
std::size_t multiplicity_of_zero(const Polynomial& p);

/// The number of distinct roots x < 0 by Sturm's theorem, each counted once whatever its multiplicity.
/// \throws Error for p = 0
std::size_t distinct_negative_roots(const Polynomial& p);

/// The same for x > 0.
std::size_t distinct_positive_roots(const Polynomial& p);

/// Sturm's sequence of a polynomial, for many questions about its real roots.
class SturmSequence {
 public:
  /// \throws Error for p = 0
  explicit SturmSequence(const Polynomial& p);
  /// The number of distinct roots in (low, high], neither of which is a multiple root.
  [[nodiscard]] std::size_t distinct_roots(const Rational& low, const Rational& high) const;

 private:
  std::vector<Polynomial> terms_;
};

/// The polynomial with the roots of p, each once. \throws Error for p = 0
Polynomial squarefree(const Polynomial& p);

}  // namespace plumbline::proofs
