#pragma once
/// \file
/// Tables as a person sees them, with the meaning that each column was given.

#include <string>
#include <vector>

#include "diagnose/draft/run_source.hpp"

namespace plumbline::diagnose {

struct SeenColumn {
  std::string title;    ///< with its unit; or empty
  std::string name;     ///< as told_columns() names the column
  std::string channel;  ///< as told_columns() names its meaning; empty where it has none
  std::string unit;     ///< that stands at it; or empty
  int sign = 1;
  bool told = false;               ///< by a person
  std::vector<std::string> first;  ///< its first fields
};

struct SeenTable {
  std::string file;
  std::vector<SeenColumn> columns;
};

/// Tables of the same titles are shown once: a meaning that is told by title is that of all.
/// \throws Error where a table cannot be read at all
std::vector<SeenTable> seen_tables(const std::vector<DraftFile>& files,
                                   const std::vector<std::string>& joints,
                                   const std::vector<ToldColumn>& told);

}  // namespace plumbline::diagnose
