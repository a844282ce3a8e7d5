#pragma once
/// \file
/// Workbooks of spreadsheets (.xlsx, Office Open XML: ECMA-376).

#include <string>
#include <vector>

namespace plumbline::diagnose {

struct Sheet {
  std::string name;
  std::string text;         ///< its cells as CSV: numbers with a point, times as ISO 8601
  std::size_t numbers = 0;  ///< how many cells have one
};

/// Whether the bytes begin as those of a workbook do.
bool is_workbook(const std::string& bytes);

/// The sheets that have numbers.
/// \param source  named in errors
/// \throws Error where the archive is damaged, or none has any
std::vector<Sheet> sheets_of(const std::string& bytes, const std::string& source);

}  // namespace plumbline::diagnose
