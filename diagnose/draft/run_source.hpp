#pragma once
/// \file
/// The columns that a run is drafted from: those of a table, some of them, or those of several files.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "diagnose/draft/column_words.hpp"
#include "diagnose/draft/written_table.hpp"

namespace plumbline::diagnose {

/// A table of readings as it came.
struct DraftFile {
  std::string name;  ///< "press.csv"
  std::string text;
};

/// A file of a run.
struct SourcePart {
  std::string file;
  WrittenTable table;
  std::size_t first = 0;  ///< place of its first column among those of the run
};

/// Columns count from 0, over all parts that are joined.
struct RunSource {
  std::string id;
  std::vector<SourcePart> parts;
  bool follow = false;                           ///< the parts have the same columns and follow one another
  std::vector<std::size_t> others = {};          ///< columns of other runs in the same table
  std::map<std::size_t, ColumnWords> told = {};  ///< content of columns whose titles do not say it

  /// In words: its file, or its id where the file has several runs or the run several files.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::size_t columns() const;
  /// The part that a column is in; of parts that follow one another the first.
  [[nodiscard]] const SourcePart& part_of(std::size_t column) const;
  /// The word above a column, and what stands there in a line of units; or empty.
  [[nodiscard]] std::string title(std::size_t column) const;
  /// The same, or "column 3" where there is no word.
  [[nodiscard]] std::string shown_title(std::size_t column) const;
  /// The same, or "3", as a person names a column.
  [[nodiscard]] std::string told_name(std::size_t column) const;
  [[nodiscard]] std::string unit(std::size_t column) const;
  /// NaN where there is none.
  [[nodiscard]] std::vector<double> numbers(std::size_t column) const;
  [[nodiscard]] std::size_t readings() const { return numbers(0).size(); }
  /// The meaning of every column; nothing of those of other runs. Of several treatments of one quantity one
  /// counts; what a motor reads is a command where no other is there.
  [[nodiscard]] std::vector<ColumnWords> words(const std::vector<std::string>& joints) const;
};

/// What a person says of a column: its title, or its number from 1, and what it holds.
struct ToldColumn {
  std::string column;
  ColumnWords words;
};

/// The columns of a source that a person says something of become so.
/// \returns the names by which they were told
std::set<std::string> take_told(RunSource& source, const std::vector<ToldColumn>& told);

/// Runs out of tables: files of one run are put together, runs side by side in one table are told apart.
/// \param joints  their names in the model
/// \param told    what a person says, which counts before what words say
/// \throws Error for a told column that no table has
std::vector<RunSource> run_sources(const std::vector<DraftFile>& files,
                                   const std::vector<std::string>& joints,
                                   const std::vector<ToldColumn>& told, Guesses& guesses);

}  // namespace plumbline::diagnose
