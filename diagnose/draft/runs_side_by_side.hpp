#pragma once
/// \file
/// Runs side by side in one table.

#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

/// A source for each run of a table: blocks of columns that repeat ("F1, x1, F2, x2"), or columns of one name
/// and a number beside one imposed quantity ("load, specimen 1, specimen 2"). Columns that do not repeat are
/// common to all runs.
std::vector<RunSource> runs_side_by_side(const RunSource& whole, const std::vector<std::string>& joints,
                                         Guesses& guesses);

}  // namespace plumbline::diagnose
