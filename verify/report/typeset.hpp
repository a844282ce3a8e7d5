#pragma once
/// \file
/// Text with formulas, as the checks write it in ASCII, set for a document.

#include <string>

namespace plumbline::verify {

/// With the signs of print: "phi" as φ, "J^T" as Jᵀ, "<=" as ≤, "*" as ·, a minus for a hyphen before a
/// number.
std::string with_signs(const std::string& text);

/// As LaTeX in ASCII: signs and Greek letters as mathematics, indices and exponents set as such.
/// \throws Error on a letter that it has no LaTeX for
std::string as_latex(const std::string& text);

}  // namespace plumbline::verify
