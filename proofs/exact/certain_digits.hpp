#pragma once
/// \file
/// What an enclosure says of a number, as a decimal.

#include <plumbline/base/interval.hpp>
#include <string>

namespace plumbline::proofs {

/// As many significant digits, `most` at most, as both ends share when rounded, so that the number rounds to
/// them too; "0" where it may be zero.
/// \throws Error where not even one digit is certain
std::string certain_digits(const Interval& x, int most);

/// The largest absolute value inside.
Interval::End magnitude(const Interval& x);

}  // namespace plumbline::proofs
