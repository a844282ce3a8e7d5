#pragma once
/// \file
/// Files as they were given, as tables that the reader of experiments takes, one a run.

#include <string>
#include <vector>

#include "diagnose/draft/draft.hpp"

namespace plumbline::diagnose {

/// Decodes, takes sheets out of workbooks, writes anew what no experiment can describe, joins loggers on one
/// clock, and cuts tables whose lines name their runs.
/// \throws Error where a file has no table, or two tables have one name
std::vector<DraftFile> tables_of(const std::vector<DraftFile>& files, const std::vector<std::string>& joints,
                                 const std::vector<ToldColumn>& told, const Ask& ask, Guesses& guesses);

}  // namespace plumbline::diagnose
