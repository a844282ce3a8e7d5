#pragma once
/// \file
/// What options accept, and what is said of a command line that is wrong: as of any other input, the place,
/// what was found and what was expected.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace plumbline::app {

CLI::Validator whole_number(std::uint64_t low,
                            std::uint64_t high = std::numeric_limits<std::uint64_t>::max());
CLI::Validator number(double low = std::numeric_limits<double>::lowest(),
                      double high = std::numeric_limits<double>::max());
CLI::Validator one_of(const std::vector<std::string>& words);

/// The error in our words.
std::string in_our_words(const CLI::ParseError& error);

}  // namespace plumbline::app
