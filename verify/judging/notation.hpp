#pragma once
/// \file
/// Formulas in sentences, which the checks write in ASCII, in the notation of print.

#include <string>

namespace plumbline::verify {

/// "phi" as φ, "J^T" as Jᵀ, "F_1" as F₁, "<=" as ≤, "*" as ·, a minus for a hyphen before a number.
std::string in_notation(const std::string& text);

}  // namespace plumbline::verify
