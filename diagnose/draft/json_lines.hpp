#pragma once
/// \file
/// Readings as JSON: an object a line (JSON Lines), or one array of objects.

#include <string>

namespace plumbline::diagnose {

/// Whether the text begins as such readings do.
bool is_json_lines(const std::string& text);

/// As CSV: a column a key in the order of their appearance, "tip.x" for a key within another, "q1", "q2" for
/// a list; an empty field where a reading has no such key.
/// \param source  named in errors
/// \throws Error where a line is no JSON object
std::string csv_of_json_lines(const std::string& text, const std::string& source);

}  // namespace plumbline::diagnose
