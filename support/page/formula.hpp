#pragma once
/// \file
/// Formulas as they are typed, set for pages.

#include <optional>
#include <string>

namespace plumbline::page {

/// A formula such as "2*k*q/(L*sin(alpha+q))" or "inv(J*J^T)*J" as MathML. Names begin with a letter or a
/// Greek letter's name; what follows is the index. Nothing for what is no formula: words, lists of counts.
std::optional<std::string> as_mathml(const std::string& formula);

}  // namespace plumbline::page
