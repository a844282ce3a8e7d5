#pragma once
/// \file
/// A table with a header, whose columns have names.

#include <string>
#include <vector>

#include "support/files/csv_file.hpp"

namespace plumbline::motion {

class LogTable {
 public:
  /// \throws Error that names the source: no row, or one of another length than the header
  LogTable(const std::string& text, std::string source);
  /// \param rows  the header first
  LogTable(std::vector<files::CsvRow> rows, std::string source);

  [[nodiscard]] std::size_t rows() const { return rows_.size() - 1; }
  /// "log.csv:7"
  [[nodiscard]] std::string place(std::size_t row) const;
  /// The number of a column.
  /// \throws Error at the place that names it where there is none
  [[nodiscard]] std::size_t column(const std::string& name, const std::string& place) const;
  [[nodiscard]] const std::string& entry(std::size_t row, std::size_t column) const {
    return rows_[row + 1].fields[column];
  }
  /// A whole column.
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const;

 private:
  std::string source_;
  std::vector<files::CsvRow> rows_;  ///< the header first
};

/// \throws Error at the place where the field is no finite number
double number_in(const std::string& field, const std::string& place);

}  // namespace plumbline::motion
