#pragma once
/// \file
/// `diagnose A --against B`: what changed between two data sets of one device; `--since`: in several.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "diagnose/api/study_files.hpp"

namespace plumbline::app {

struct ChangeOptions {
  diagnose::StudyFiles after;
  std::string before;      ///< folder of the state of reference, or a state that runs of `after` name
  std::string json, html;  ///< or empty
  bool check = false;
};

/// Ends by `throw CLI::RuntimeError` with the status of the check, where that is asked for and is not zero.
void diagnose_change(const ChangeOptions& options, const CLI::App& verb);

/// The same of logs in motion; `after.folder` and `before` are folders of such.
void diagnose_motion_change(const ChangeOptions& options, const CLI::App& verb);

struct SinceOptions {
  std::vector<std::string> folders;  ///< of data sets; or one whose runs name several states
  std::string model, effects;        ///< files, or empty
  std::string json, html;            ///< or empty
};

/// Every data set against the first one, in the order of their dates where all have one, else as listed.
/// Ends by `throw CLI::RuntimeError(1)` where one could not be compared; the others are reported.
void diagnose_since(const SinceOptions& options, const CLI::App& verb);

}  // namespace plumbline::app
