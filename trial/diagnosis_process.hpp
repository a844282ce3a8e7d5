#pragma once
/// \file
/// The diagnosis as a process of its own, which sees one experiment and nothing else.

#include <chrono>
#include <filesystem>
#include <string>

namespace plumbline::trial {

struct Diagnosed {
  double seconds = 0;
  std::string failure;  ///< empty where the process ended well
};

/// Runs `executable diagnose COPY --json report`. COPY is a folder made for this alone, with the experiment's
/// own files: experiment.toml and the CSV files.
/// \throws Error when no process can be started
Diagnosed diagnose_alone(const std::filesystem::path& executable, const std::filesystem::path& experiment,
                         const std::filesystem::path& report, std::chrono::duration<double> patience);

}  // namespace plumbline::trial
