#include "support/page/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace plumbline::page {
namespace {

/// Three letters in a row: not a number with its unit, "12 of 20" or "5 to 7 %".
bool has_word(const std::string& cell) {
  std::size_t letters = 0;
  for (const char c : cell) {
    letters = std::isalpha(static_cast<unsigned char>(c)) != 0 ? letters + 1 : 0;
    if (letters == 3) return true;
  }
  return false;
}

/// Columns of words are left-aligned.
bool wordy(const Table& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(),
                     [&](const auto& row) { return has_word(row[column]); });
}

}  // namespace

std::string terminal_table(const Table& table) {
  std::string text;
  std::vector<std::size_t> width;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    width.push_back(table.header[c].size());
    for (const auto& row : table.rows) width[c] = std::max(width[c], row[c].size());
  }
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string one = " ";
    for (std::size_t c = 0; c < cells.size(); ++c)
      one += wordy(table, c) ? fmt::format(" {:<{}} ", cells[c], width[c])
                             : fmt::format(" {:>{}} ", cells[c], width[c]);
    text += one.substr(0, one.find_last_not_of(' ') + 1) + "\n";
  };
  line(table.header);
  for (const auto& row : table.rows) line(row);
  return text;
}

std::string markdown_table(const Table& table) {
  std::string text = fmt::format("| {} |\n|", fmt::join(table.header, " | "));
  for (std::size_t c = 0; c < table.header.size(); ++c) text += wordy(table, c) ? " --- |" : " ---: |";
  for (const auto& row : table.rows) {
    text += "\n|";
    for (std::string cell : row) {
      for (std::size_t at = 0; (at = cell.find('|', at)) != std::string::npos; at += 2) cell.insert(at, "\\");
      text += " " + cell + " |";
    }
  }
  return text + "\n";
}

}  // namespace plumbline::page
