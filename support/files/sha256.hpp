#pragma once
/// \file
/// The digest that closes a file.

#include <filesystem>
#include <string>
#include <vector>

namespace plumbline::files {

/// SHA-256 of a text as 64 hexadecimal digits.
std::string sha256(const std::string& text);

/// Of files, one after the other, as `cat FILES | sha256sum` has it; "-" is standard input. What cannot be
/// read counts as empty: who needs it will say so.
std::string sha256(const std::vector<std::filesystem::path>& files);

}  // namespace plumbline::files
