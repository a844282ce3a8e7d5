#pragma once
/// \file
/// Whole text files, read or refused with a reason.

#include <filesystem>
#include <string>

namespace plumbline::files {

/// Files beyond this many bytes are no input of ours: a chain of a million links takes 20 MB.
constexpr std::size_t largest_file = std::size_t{1} << 28;

/// "-".
bool is_standard_input(const std::filesystem::path& path);

/// What errors call it: "-" is "standard input".
std::string source_name(const std::filesystem::path& path);

/// The content of a file or a pipe, as UTF-8; of "-" what standard input holds. What a pipe held is the same
/// when it is read again.
/// \throws Error that names the file: missing, a directory, a device, not readable, larger than
///         `largest_file`, empty, or not UTF-8 (with the line)
std::string read_text(const std::filesystem::path& path);

/// What every text from outside goes through.
/// \throws Error that names the source: empty but for white space, or (with the line) not UTF-8
void require_text(const std::string& text, const std::string& source);

}  // namespace plumbline::files
