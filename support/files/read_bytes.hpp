#pragma once
/// \file
/// Whole files, whatever is in them.

#include <filesystem>
#include <string>

namespace plumbline::files {

/// The bytes of a file or a pipe; of "-" what standard input holds.
/// \throws Error that names the file: missing, a directory, a device, not readable, or larger than
///         `largest_file`
std::string read_bytes(const std::filesystem::path& path);

}  // namespace plumbline::files
