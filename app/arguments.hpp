#pragma once
/// \file
/// What options accept, and what is said of a command line that is wrong: as of any other input, the place,
/// what was found and what was expected.

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
/// A variable of the shell that is not set is no answer: it would be taken for no option.
CLI::Validator something();
CLI::Validator one_of(const std::vector<std::string>& words);

/// An option that names a file or a folder to write.
CLI::Option* add_output(CLI::App& verb, const std::string& name, std::string& path, const std::string& what,
                        const std::string& type = "FILE");
/// The same of a file that goes to standard output where no name is given.
CLI::Option* add_printed_output(CLI::App& verb, const std::string& name, std::string& path,
                                const std::string& what);

/// What the user asked of the verb, as it would be typed again: but for what is to be written, on which no
/// result depends. \param inputs  the files that are read, whichever option names them
std::string asked(const CLI::App& verb, const std::vector<std::filesystem::path>& inputs);

/// The error in our words.
std::string in_our_words(const CLI::ParseError& error);

}  // namespace plumbline::app
