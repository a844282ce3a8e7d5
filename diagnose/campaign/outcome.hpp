#pragma once
/// \file
/// What a diagnosis of one of many experiments came to.

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trial/answer.hpp"
#include "support/work/journal.hpp"

namespace plumbline::campaign {

using Day = std::chrono::sys_days;

struct Outcome {
  std::string name;         ///< of the folder
  std::optional<Day> date;  ///< that the experiment states
  std::string failure;      ///< empty where there is a report
  trial::Report report = {};
};

/// Diagnoses every folder, several at once, each in a process of its own: what fails, or dies, is named and
/// ends no other.
struct Work {
  std::vector<std::string> words;             ///< further arguments of each diagnosis
  std::vector<std::filesystem::path> inputs;  ///< the files that these name
  std::filesystem::path reports;              ///< where NAME.json and NAME.html go
  bool pages = false;                         ///< whether pages are wanted too
  work::Journal* journal = nullptr;           ///< where something is to be kept of work that is cut off
};
std::vector<Outcome> diagnose_all(const std::vector<std::filesystem::path>& folders, const Work& work,
                                  const std::function<void()>& advance);

/// Names of folders, each once: what two have in common is preceded by the folder around.
std::vector<std::string> names_of(const std::vector<std::filesystem::path>& folders);

}  // namespace plumbline::campaign
