#pragma once
/// \file
/// Sentences with formulas between backticks, such as "the force `F_x⁰ = 1/max|λ_i|`", as LaTeX and as
/// Markdown.
///
/// In a formula letters stand for themselves, Greek ones too; an index or exponent is raised or lowered
/// signs, or one letter behind _ or ^, or several in braces; a word of two letters and more is a function.

#include <string>

namespace plumbline::verify {

/// In ASCII. \throws Error on a letter that it has no LaTeX for
std::string as_latex(const std::string& text);

/// With HTML's marks for indices, as Markdown has none.
std::string as_markdown(const std::string& text);

/// Without marks.
std::string as_plain(std::string text);

}  // namespace plumbline::verify
