#pragma once
/// \file
/// Many experiments, diagnosed at once and compared.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plumbline::app {

struct ManyExperiments {
  std::vector<std::string> folders;  ///< other arguments are skipped, with a remark
  std::string reports;               ///< folder for the reports; empty for none
  std::string json, html;            ///< of the comparison
  std::vector<std::string> words;    ///< further arguments of each diagnosis
  std::vector<std::string> inputs;   ///< files that these words name
};

/// Ends by `throw CLI::RuntimeError(1)` where an experiment could not be diagnosed; the others are reported.
void diagnose_many(const ManyExperiments& many, const CLI::App& verb);

}  // namespace plumbline::app
