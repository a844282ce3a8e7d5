#pragma once
/// \file
/// Determinant, rank and pencil of exact matrices, by Bareiss's elimination in integers: no fraction arises,
/// and every intermediate number is a minor of the matrix.

#include <cstddef>
#include <plumbline/base/number.hpp>

#include "proofs/exact/polynomial.hpp"

namespace plumbline::proofs {

/// The determinant of a square matrix.
Rational determinant(const Matrix<Rational>& matrix);

std::size_t rank(const Matrix<Rational>& matrix);

/// det(P + x Q) as a polynomial in x, for square P and Q of one size.
Polynomial pencil_determinant(const Matrix<Rational>& P, const Matrix<Rational>& Q);

}  // namespace plumbline::proofs
