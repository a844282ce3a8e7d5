#pragma once
/// \file
/// What stands above the rows of a table.

#include <optional>
#include <string>
#include <vector>

#include "diagnose/draft/table_cut.hpp"

namespace plumbline::diagnose {

/// Places are among the lines.
struct TableHeader {
  std::optional<std::size_t> names;  ///< the line of words
  std::optional<std::size_t> units;  ///< the line of units below it
  std::vector<std::string> words;    ///< one a column; those of the lines above in front where names repeat
  bool several_lines = false;        ///< whether it has words of several lines
};

TableHeader table_header(const std::vector<Line>& lines, const Cut& cut);

}  // namespace plumbline::diagnose
