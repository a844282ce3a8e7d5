#pragma once
/// \file
/// A floating-point number is a fraction.

#include <plumbline/base/number.hpp>

namespace plumbline::proofs {

/// The value, which must be finite, of a number of MPFR.
template <class Real>
Rational exactly(const Real& x) {
  Rational result;
  mpfr_get_q(result.backend().data(), x.backend().data());
  return result;
}

}  // namespace plumbline::proofs
