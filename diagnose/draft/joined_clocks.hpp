#pragma once
/// \file
/// Two loggers on one clock, at times of their own.

#include <string>
#include <vector>

#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

/// Files that have one run together, the loads in one and the places in the other, at other times of one
/// clock, become one table: the values of the second between its readings, at the times of the first. Others
/// are left as they are.
/// \param guesses  gets what was joined, and over which time
std::vector<DraftFile> joined_clocks(std::vector<DraftFile> files, const std::vector<std::string>& joints,
                                     Guesses& guesses);

}  // namespace plumbline::diagnose
