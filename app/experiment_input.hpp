#pragma once
/// \file
/// The experiment of a verb, and the nominal model with which it is compared.

#include <filesystem>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::app {

struct ExperimentInput {
  std::string folder;      ///< empty: the experiment in docs/examples/experiment
  std::string model;       ///< file with the nominal model; empty: the experiment's own
  std::string effects;     ///< file with user effects; or empty
  std::string state = {};  ///< of the device: its runs alone; empty: all runs are of one

  /// Every file that is read.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;
};

diagnose::Experiment experiment_of(const ExperimentInput& input);
/// The bench before any measurement.
diagnose::Experiment bench_of(const ExperimentInput& input);

/// The file of the nominal model: that of --model, or the one that experiment.toml names for an arm; empty
/// where there is none.
std::filesystem::path model_file(const ExperimentInput& input);

/// The decimated experiment or bench, with the user's effects among the candidates.
/// \throws Error where one of them is undefined along the nominal model's runs
diagnose::Study study_of(const ExperimentInput& input, const diagnose::Experiment& experiment);

}  // namespace plumbline::app
