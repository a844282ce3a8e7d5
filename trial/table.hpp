#pragma once
/// \file
/// A table as a terminal or Markdown shows it.

#include <string>
#include <vector>

namespace plumbline::trial {

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Columns aligned by blanks: words to the left, numbers to the right.
std::string terminal_table(const Table& table);
std::string markdown_table(const Table& table);

}  // namespace plumbline::trial
