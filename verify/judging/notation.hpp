#pragma once
/// \file
/// Formulas in sentences, which the checks write in ASCII, in the notation of print.

#include <string>

namespace plumbline::verify {

/// "phi" as φ, "J^T" as Jᵀ, "F_1" as F₁, "<=" as ≤, "*" as ·, a minus for a hyphen before a number.
std::string in_notation(const std::string& text);

/// A formula as the checks read it, as a line of print: "k1*q1" as k₁q₁, "sin(2*phi)-2*sin(phi)" as
/// sin 2φ − 2 sin φ, "Fx" as F_x.
std::string formula_in_print(const std::string& formula);

}  // namespace plumbline::verify
