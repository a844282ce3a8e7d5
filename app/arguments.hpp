#pragma once
/// \file
/// Validators of options, and errors of the command line in the form of all others: place, found, expected.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace plumbline::app {

CLI::Validator whole_number(std::uint64_t low,
                            std::uint64_t high = std::numeric_limits<std::uint64_t>::max());
CLI::Validator number(double low = std::numeric_limits<double>::lowest(),
                      double high = std::numeric_limits<double>::max());
/// Refuses an empty text, such as an unset variable of the shell.
CLI::Validator something();
CLI::Validator one_of(const std::vector<std::string>& words);

/// Makes an option one of two values with a comma between them.
/// \param names  of the values, as --help shows them
CLI::Option* as_pair(CLI::Option* option, const std::string& names);
/// The names in a list with commas between them; none in an empty text.
std::vector<std::string> names_in(const std::string& list);

/// An option that names a file or a folder to write.
CLI::Option* add_output(CLI::App& verb, const std::string& name, std::string& path, const std::string& what,
                        const std::string& type = "FILE");
/// The same; without a name the file goes to standard output.
CLI::Option* add_printed_output(CLI::App& verb, const std::string& name, std::string& path,
                                const std::string& what);

/// The command as the user would type it again, without the files to write.
/// \param inputs  the files that are read
std::string asked(const CLI::App& verb, const std::vector<std::filesystem::path>& inputs);

/// The parser's error as an Error.
std::string in_our_words(const CLI::ParseError& error);

}  // namespace plumbline::app
