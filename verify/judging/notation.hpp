#pragma once
/// \file
/// Formulas in sentences, which the checks write in ASCII, in the notation of print.

#include <string>
#include <vector>

namespace plumbline::verify {

/// "phi" as φ, "J^T" as Jᵀ, "F_1" as F₁, "<=" as ≤, "*" as ·, a minus for a hyphen before a number.
std::string in_notation(const std::string& text);

/// A formula as the checks read it, as a line of print: "k1*q1" as k₁q₁, "sin(2*phi)-2*sin(phi)" as
/// sin 2φ − 2 sin φ, "Fx" as F_x.
std::string formula_in_print(const std::string& formula);

/// An entry of a print as it stands in a sentence: one of a claim's `words`, a number or counts as they are,
/// a formula in print between backticks.
std::string set_in_sentence(const std::string& entry, const std::vector<std::string>& words);

/// Names with an index or exponent between backticks, as formulas are.
std::string with_marks(const std::string& text);

/// What was found, as a sentence: with a capital where it begins with a word, names with an index between
/// backticks, and a full stop.
std::string as_sentence(const std::string& found);

}  // namespace plumbline::verify
