#pragma once
/// \file
/// The diagnosis in its own process, which sees one experiment and nothing else.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumbline::campaign {

struct Diagnosed {
  double seconds = 0;
  std::string failure;  ///< empty after success
};

/// Runs `executable diagnose folder words…` in the folder `here`; without patience there is no time limit.
/// \throws Error when no process can be started
Diagnosed run_diagnosis(const std::filesystem::path& executable, const std::filesystem::path& folder,
                        const std::vector<std::string>& words,
                        std::optional<std::chrono::duration<double>> patience = std::nullopt,
                        const std::filesystem::path& here = ".");

/// Runs `executable diagnose experiment --json report` in a new folder with a copy of the experiment's own
/// files, so that the report does not depend on the place.
/// \throws Error when no process can be started
Diagnosed diagnose_alone(const std::filesystem::path& executable, const std::filesystem::path& experiment,
                         const std::filesystem::path& report, std::chrono::duration<double> patience);

}  // namespace plumbline::campaign
