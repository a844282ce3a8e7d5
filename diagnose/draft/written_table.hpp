#pragma once
/// \file
/// The format of a table of readings, guessed from its text.

#include <string>
#include <vector>

#include "diagnose/bench/sample_table.hpp"
#include "diagnose/draft/guess.hpp"

namespace plumbline::diagnose {

struct WrittenTable {
  SampleFormat format;             ///< but for its columns
  SampleTable table;               ///< so read
  std::vector<std::string> names;  ///< a word for each column: of the header, or of a comment above the rows
  std::vector<std::string> units;  ///< what stands for each in a line of units; or empty
  Guesses guesses;

  [[nodiscard]] std::size_t columns() const { return table.rows.front().fields.size(); }
  /// The numbers of a column, NaN where there is none.
  [[nodiscard]] std::vector<double> numbers(std::size_t column) const;
};

/// \param source  named in errors
/// \throws Error where no way to read it gives rows of numbers
WrittenTable written_table(const std::string& text, const std::string& source);

}  // namespace plumbline::diagnose
