#pragma once
/// \file
/// Many experiments, diagnosed at once and compared.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plumbline::app {

struct ManyExperiments {
  std::vector<std::string> folders;  ///< what is no folder is passed over, and said
  std::string reports;               ///< folder for the report of each; empty for none
  std::string json, html;            ///< of the report for all
  std::vector<std::string> words;    ///< that each diagnosis is called with
  std::vector<std::string> inputs;   ///< files that these words name
};

/// Ends by `throw CLI::RuntimeError(1)` where an experiment could not be diagnosed; the others are reported.
void diagnose_many(const ManyExperiments& many, const CLI::App& verb);

}  // namespace plumbline::app
