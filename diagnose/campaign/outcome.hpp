#pragma once
/// \file
/// The outcome of one of many diagnoses.

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnose/campaign/stated_report.hpp"
#include "support/work/journal.hpp"

namespace plumbline::campaign {

using Day = std::chrono::sys_days;

struct Outcome {
  std::string name;         ///< of the folder
  std::optional<Day> date;  ///< of the experiment
  std::string failure;      ///< empty where there is a report
  StatedReport report = {};
};

/// Diagnoses every folder, several at once, each in its own process; a failure is named and stops no other.
struct Work {
  std::vector<std::string> words;             ///< further arguments of each diagnosis
  std::vector<std::filesystem::path> inputs;  ///< the files that these name
  std::filesystem::path reports;              ///< folder for NAME.json and NAME.html
  bool pages = false;                         ///< pages are written too
  work::Journal* journal = nullptr;           ///< keeps finished work, where it can be interrupted
};
std::vector<Outcome> diagnose_all(const std::vector<std::filesystem::path>& folders, const Work& work,
                                  const std::function<void()>& advance);

/// Unique names of folders; the parent folder precedes a name that two have in common.
std::vector<std::string> names_of(const std::vector<std::filesystem::path>& folders);

}  // namespace plumbline::campaign
