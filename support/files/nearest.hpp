#pragma once
/// \file
/// The known word that a mistyped one is nearest to.

#include <string>
#include <string_view>
#include <vector>

namespace plumbline::files {

/// By the fewest letters that are put in, left out, replaced, or swapped with their neighbour (Damerau 1964,
/// each letter changed once); empty where that is more than a third of the word, or all of it.
std::string nearest(std::string_view word, const std::vector<std::string>& known);

/// What is expected instead of a word: the nearest known one first, then all: "diagnose, or one of check
/// new".
std::string expected_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace plumbline::files
