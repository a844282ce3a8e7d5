#pragma once
/// \file
/// The command line program.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace plumbline::app {

/// Name, version and, where it is known, the commit.
std::string program_name();

/// `plumbline` without verbs.
std::unique_ptr<CLI::App> bare_command();
/// `plumbline` with all its verbs.
std::unique_ptr<CLI::App> whole_command();

/// Runs a command line.
/// \returns the exit status: 0 done, 1 a claim or a check failed, 2 bad input
int run(CLI::App& command, int argc, char** argv);

}  // namespace plumbline::app
