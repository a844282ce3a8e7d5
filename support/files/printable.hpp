#pragma once
/// \file
/// Text from files, as it may be shown: in a terminal, in one line of an error, on a page.

#include <filesystem>
#include <string>
#include <string_view>

namespace plumbline::files {

/// Where the first byte stands that is no UTF-8, or the first NUL; npos where all is text.
std::size_t first_bad_byte(std::string_view text);

/// The text with every control character, line break, mark that turns the direction of writing and byte that
/// is no UTF-8 written out: "\x1b", "\u202e".
std::string printable(std::string_view text);

/// A value as an error shows it: printable, and cut where it is longer than a line can take.
std::string shown(std::string_view text);

/// Text that reaches terminals and pages.
/// \throws Error at the place where it holds anything that printable() writes out
void require_printable(const std::string& text, const std::string& place);

/// A name that stands in errors and reports among other words, such as that of a chain or a run.
/// \throws Error at the place as require_printable() does, and where it is longer than 200 bytes
void require_name(const std::string& name, const std::string& place);

/// A path as text that goes into JSON.
/// \throws Error where it is no UTF-8
std::string text_of(const std::filesystem::path& path);

}  // namespace plumbline::files
