#pragma once
/// \file
/// The text of a drafted experiment.toml.

#include <string>
#include <vector>

#include "diagnose/draft/drafted_run.hpp"

namespace plumbline::diagnose {

/// Runs that are drafted, and what holds for all of them.
struct DraftedExperiment {
  std::string name;
  std::vector<DraftedRun> runs;
  bool absolute_angles = false;
};

/// With a comment behind what was guessed, and the line by which editors find the schema.
std::string settings_text(const DraftedExperiment& experiment, const DraftModel& model);

}  // namespace plumbline::diagnose
