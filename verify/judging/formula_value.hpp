#pragma once
/// \file
/// The values of formulas, in intervals.

#include <ginac/ginac.h>

#include <map>
#include <plumbline/base/interval.hpp>
#include <string>

namespace plumbline::verify {

using Values = std::map<std::string, Interval>;  ///< by symbol

/// The value of an expression in + * ^, sin, cos, tan and Pi where its symbols have these values.
/// \throws Error at another function or symbol, and at a power that is no half integer
Interval value_of(const GiNaC::ex& expression, const Values& values = {});

/// A formula whose decimals are written as the fractions that they are: "0.4*x" as "(2/5)*x".
std::string with_fractions(const std::string& formula);

/// The value of a number as it is printed: "-0.3179", "5/2", "pi/10".
/// \throws Error that quotes what is none
Interval number(const std::string& text);

}  // namespace plumbline::verify
