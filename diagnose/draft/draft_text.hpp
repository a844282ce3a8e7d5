#pragma once
/// \file
/// The text of a drafted experiment.toml.

#include <string>
#include <vector>

#include "diagnose/draft/drafted_loads.hpp"
#include "diagnose/draft/drafted_run.hpp"

namespace plumbline::diagnose {

/// All drafted runs and their common settings.
struct DraftedExperiment {
  std::string name;
  std::vector<DraftedRun> runs;
  std::vector<DraftedLoad> loads = {};
  bool absolute_angles = false;
};

/// The first line names the schema for editors.
std::string settings_text(const DraftedExperiment& experiment, const DraftModel& model);

}  // namespace plumbline::diagnose
