#pragma once
/// \file
/// The diagnosis as a process of its own, which sees one experiment and nothing else.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::trial {

struct Diagnosed {
  double seconds = 0;
  std::string failure;  ///< empty where the process ended well
};

/// Runs `executable diagnose folder words…` in the folder `here`, without a limit of time where there is no
/// patience. \throws Error when no process can be started
Diagnosed run_diagnosis(const std::filesystem::path& executable, const std::filesystem::path& folder,
                        const std::vector<std::string>& words,
                        std::optional<std::chrono::duration<double>> patience = std::nullopt,
                        const std::filesystem::path& here = ".");

/// Runs `executable diagnose experiment --json report` in a folder made for this alone, with a copy of the
/// experiment's own files: experiment.toml and the CSV files. So the report does not depend on the place.
/// \throws Error when no process can be started
Diagnosed diagnose_alone(const std::filesystem::path& executable, const std::filesystem::path& experiment,
                         const std::filesystem::path& report, std::chrono::duration<double> patience);

}  // namespace plumbline::trial
