#pragma once
/// \file
/// Where a verb has its experiment from, and the nominal model that it is compared with.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::app {

struct ExperimentInput {
  std::string folder;   ///< without one: the experiment in docs/examples/experiment
  std::string model;    ///< file that has the nominal model; or none: the experiment's own
  std::string effects;  ///< file with effects of the user's own; or none

  /// Every file that is read.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
};

diagnose::Experiment experiment_of(const ExperimentInput& input);
/// The bench, before anything was measured.
diagnose::Experiment bench_of(const ExperimentInput& input);

/// The experiment or bench, decimated, in which the user's effects are looked for too.
/// \throws Error where one of them has no value along the nominal model's runs
diagnose::Study study_of(const ExperimentInput& input, const diagnose::Experiment& experiment);

}  // namespace plumbline::app
