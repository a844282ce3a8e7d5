#pragma once
/// \file
/// Decimal text and exact fractions, both ways.

#include <optional>
#include <plumbline/base/number.hpp>
#include <string>
#include <string_view>

namespace plumbline::proofs {

/// The exact value of a decimal such as "-1.25e-3" (sign, digits, point and exponent optional; nothing else,
/// no surrounding space). Nothing for other text, or for an exponent beyond ±100000.
std::optional<Rational> parse_decimal(std::string_view text);

/// x rounded to nearest (ties away from zero) at the given number of significant digits, in plain notation
/// for decimal exponents from -5 to `digits` and scientific notation otherwise. Exact zero is "0".
std::string to_decimal(const Rational& x, int digits);

/// x 10^exponent.
Rational shifted(const Rational& x, int exponent);

/// One unit in a significant digit (from 1) of x, which is not zero: 0.01 for the third digit of 9.87.
Rational unit_in_digit(const Rational& x, int digit);

/// x itself: a decimal where it has a finite one, otherwise a fraction "p/q".
std::string to_exact(const Rational& x);

/// x rounded to nearest (ties away from zero) at so many places behind the point, as printed tables do.
std::string to_fixed(const Rational& x, int places);

}  // namespace plumbline::proofs
