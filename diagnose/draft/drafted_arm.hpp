#pragma once
/// \file
/// Drafted runs of an arm in space: poses that were commanded, and what was read there.

#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"

namespace plumbline::diagnose {

struct DraftedArm {
  std::string settings;           ///< the text of experiment.toml
  std::vector<DraftFile> tables;  ///< a run each: the columns of docs/arms.md, in SI
  Guesses guesses;
  std::string question;                        ///< or empty
  std::vector<std::vector<std::size_t>> used;  ///< by source, the columns that are in its table
};

/// \throws Error where a run has no commanded or reached angle for some joint, or nothing is read
DraftedArm drafted_arm(const std::string& name, const std::vector<RunSource>& sources,
                       const DraftModel& model, const Ask& ask);

}  // namespace plumbline::diagnose
