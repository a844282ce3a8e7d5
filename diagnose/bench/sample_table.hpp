#pragma once
/// \file
/// The text of a sample file as rows of fields.

#include <string>
#include <vector>

#include "diagnose/bench/sample_format.hpp"
#include "support/files/csv_file.hpp"

namespace plumbline::diagnose {

struct SampleTable {
  std::vector<std::string> header;  ///< empty where the file has none
  std::size_t header_line = 1;      ///< 0 for a table that is not in a file
  std::vector<files::CsvRow> rows;  ///< all with as many fields as the header
  bool transposed = false;          ///< a row was a field of every line; its number counts these

  /// "press.csv:7", or of a transposed table "press.csv, field 7".
  [[nodiscard]] std::string place_of(std::size_t row, const std::string& source) const;
};

/// \throws Error that names the source and the line: quotes that do not match, no row, a row of another
/// length
SampleTable parse_sample_table(const std::string& text, const std::string& source,
                               const SampleFormat& format);

/// "; with csv.delimiter = \";\" it would be 5 columns", where an unexpected header splits into more columns
/// with another delimiter; else empty.
std::string other_delimiter(const SampleTable& table, const SampleFormat& format);

}  // namespace plumbline::diagnose
