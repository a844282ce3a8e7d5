#pragma once
/// \file
/// Many diagnoses, each in its own process, shared among threads or ranks (support/work).

#include <functional>

#include "diagnose/campaign/diagnosis_process.hpp"
#include "support/work/journal.hpp"
#include "support/work/work_list.hpp"

namespace plumbline::campaign {

/// One of many diagnoses.
struct Assignment {
  std::filesystem::path experiment;           ///< the folder
  std::filesystem::path report;               ///< the JSON file that it writes
  std::vector<std::string> words;             ///< further arguments
  std::vector<std::filesystem::path> inputs;  ///< the files that these name
  /// The trial's diagnosis gets a copy of the experiment's own files alone, and a time limit.
  std::optional<std::chrono::duration<double>> alone = std::nullopt;
};

/// The item for another process.
extern const work::Task diagnosis_task;

/// The outcomes, in order. A journal keeps a successful diagnosis while experiment, inputs and words are
/// unchanged and its report exists.
std::vector<Diagnosed> diagnose_all(const std::vector<Assignment>& assignments, work::Journal* journal,
                                    const std::function<void()>& advance);

}  // namespace plumbline::campaign
