#pragma once
/// \file
/// A table for a terminal or Markdown.

#include <string>
#include <vector>

namespace plumbline::page {

struct Table {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Columns aligned by blanks: words left, numbers right.
std::string terminal_table(const Table& table);
std::string markdown_table(const Table& table);

}  // namespace plumbline::page
