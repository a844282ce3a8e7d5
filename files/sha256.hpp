#pragma once
/// \file
/// The digest that closes a file.

#include <string>

namespace plumbline::files {

/// SHA-256 of a text as 64 hexadecimal digits.
std::string sha256(const std::string& text);

}  // namespace plumbline::files
