#pragma once
/// \file
/// Files that hold one run together: its channels, or its beginning and end.

#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

/// A source for each run. Two files are one run where they have the same columns and the second goes on, in
/// time and in every channel, within two usual steps; or where they have different channels, forces here and
/// places or angles there, at the same times.
std::vector<RunSource> files_of_runs(const std::vector<DraftFile>& files,
                                     const std::vector<std::string>& joints, Guesses& guesses);

}  // namespace plumbline::diagnose
