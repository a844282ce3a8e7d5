#pragma once
/// \file
/// `diagnose A --against B`: what changed between two data sets of one device.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "diagnose/api/study_files.hpp"

namespace plumbline::app {

struct ChangeOptions {
  diagnose::StudyFiles after;
  std::string before;      ///< folder of the state of reference
  std::string json, html;  ///< or empty
  bool check = false;
};

/// Ends by `throw CLI::RuntimeError` with the status of the check, where that is asked for and is not zero.
void diagnose_change(const ChangeOptions& options, const CLI::App& verb);

}  // namespace plumbline::app
