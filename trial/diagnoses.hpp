#pragma once
/// \file
/// Many diagnoses, shared among whoever works (work/), each a process of its own.

#include <functional>

#include "trial/diagnosis_process.hpp"
#include "support/work/journal.hpp"
#include "support/work/work_list.hpp"

namespace plumbline::trial {

/// One of many diagnoses.
struct Assignment {
  std::filesystem::path experiment;           ///< the folder
  std::filesystem::path report;               ///< the file in JSON that it writes
  std::vector<std::string> words;             ///< further arguments
  std::vector<std::filesystem::path> inputs;  ///< the files that these name
  /// The trial's diagnosis sees a copy of the experiment's own files and nothing else, for so long at most.
  std::optional<std::chrono::duration<double>> alone = std::nullopt;
};

/// What another process is told.
extern const work::Task diagnosis_task;

/// What came of each, in their order. A journal holds a diagnosis that ended well, as long as experiment,
/// inputs and words are the same and its report is there.
std::vector<Diagnosed> diagnose_all(const std::vector<Assignment>& assignments, work::Journal* journal,
                                    const std::function<void()>& advance);

}  // namespace plumbline::trial
