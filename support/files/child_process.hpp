#pragma once
/// \file
/// Other programs, called without a shell.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::files {

struct Ended {
  std::string failure;  ///< empty where the program ended well
  std::string out;      ///< what it wrote to standard output
  std::string err;      ///< and to standard error
};

/// Runs a program with these words, found as the shell finds it, and waits for it. It is killed when its time
/// is up, and by the system when this process dies. What it reads and writes stays in memory. Programs that
/// we start share the machine: OMP_NUM_THREADS tells each to use one core.
/// \param input     its standard input
/// \param patience  how long it may take; no limit without it
/// \param folder    that it works in; this process's own without it
/// \throws Error when it cannot be started
Ended run_program(const std::vector<std::string>& words, const std::string& input,
                  std::optional<std::chrono::duration<double>> patience = std::nullopt,
                  const std::filesystem::path& folder = ".");

}  // namespace plumbline::files
