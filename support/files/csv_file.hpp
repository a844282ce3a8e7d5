#pragma once
/// \file
/// Comma-separated values: fields as text, with the line that each row starts on.

#include <cstddef>
#include <string>
#include <vector>

namespace plumbline::files {

struct CsvRow {
  std::size_t line;  ///< counted from 1
  std::vector<std::string> fields;
};

/// All rows of a text, the header line first; blank lines are passed over, blanks around fields dropped.
/// \throws Error that names the source and the line where quotes do not match, or where there is no row
std::vector<CsvRow> parse_csv(const std::string& text, const std::string& source, char delimiter = ',');

/// A field, quoted where it has to be.
std::string csv_field(const std::string& value);

}  // namespace plumbline::files
