#pragma once
/// \file
/// What a system shows of a command, written from its options: the same tree that parses the arguments.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plumbline::app {

/// A page for man(1), in the macros of man(7).
std::string man_page(const CLI::App& command, const std::string& version);
/// A file for bash-completion(7): `/usr/share/bash-completion/completions/plumbline`.
std::string bash_completion(const CLI::App& command);
/// A file for zsh's compsys: `_plumbline` in a folder of `$fpath`.
std::string zsh_completion(const CLI::App& command);

/// The verbs, in the order of the help.
std::vector<const CLI::App*> verbs(const CLI::App& command);
/// The names of an option as they are typed: "-h", "--help"; none for a positional argument.
std::vector<std::string> flags(const CLI::Option& option);
/// Whether an argument follows it.
bool takes_value(const CLI::Option& option);
/// The values that it may have where these are listed, else empty.
std::vector<std::string> choices(const CLI::Option& option);
/// Whether a file or a folder is meant.
bool is_file(const CLI::Option& option);
bool is_folder(const CLI::Option& option);

}  // namespace plumbline::app
