#pragma once
/// \file
/// Printed matrix formulas, such as "K*q" or "J*inv(J^T*J)", on exact matrices.

#include <map>
#include <optional>
#include <plumbline/base/number.hpp>
#include <string>

namespace plumbline::verify {

using NamedMatrices = std::map<std::string, Matrix<Rational>>;

/// The value of a formula in + - * ^T, brackets, numbers, inv() and pinv(), the Moore-Penrose inverse of a
/// matrix of full column or row rank. A 1 x 1 matrix is a scalar. Nothing where sizes do not fit or an
/// inverse does not exist: then the formula means nothing.
/// \throws Error where it cannot be read or uses another name
std::optional<Matrix<Rational>> evaluated(const std::string& formula, const NamedMatrices& values);

}  // namespace plumbline::verify
