#pragma once
/// \file
/// Loads along the chain, drafted from columns of tensions and pressures.

#include <string>
#include <vector>

#include "diagnose/draft/drafted_run.hpp"

namespace plumbline::diagnose {

/// A load along the chain, as experiment.toml is to say it.
struct DraftedLoad {
  std::string name;                ///< of its covariate
  Kind kind;                       ///< tension or pressure
  std::vector<double> moment_arm;  ///< at each joint, m or m³; empty where nobody has said it
};

/// What experiment.toml calls a kind of load, and what moment arms it has.
struct LoadWords {
  const char* key;          ///< "tendon"
  const char* arms;         ///< "radius"
  const Quantity* of_arms;  ///< a length or a volume
  const char* arms_are;     ///< in words
};
const LoadWords& load_words(Kind kind);

/// Takes the tensions and pressures of all runs for covariates, and those that alone move a run for loads
/// along the chain. No table tells moment arms: a person is asked, or they stay open.
/// \param runs     get their covariates; 0, which is asked about, where a run has no column of a load
/// \param guesses  gets what was decided, and why
/// \throws Error for an answer that is not a number for each joint, with a unit or without
std::vector<DraftedLoad> drafted_loads(std::vector<DraftedRun>& runs, const DraftModel& model, const Ask& ask,
                                       Guesses& guesses);

/// What a person still has to say of the loads of a chain of so many joints, in a line; or empty.
std::string open_question(const std::vector<DraftedLoad>& loads, std::size_t joints);

}  // namespace plumbline::diagnose
