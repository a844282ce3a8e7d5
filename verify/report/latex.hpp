#pragma once
/// \file
/// Text with formulas as LaTeX.

#include <string>

namespace plumbline::verify {

/// In ASCII: signs and Greek letters as mathematics, indices and exponents set as such.
/// \throws Error on a letter that it has no LaTeX for
std::string as_latex(const std::string& text);

}  // namespace plumbline::verify
