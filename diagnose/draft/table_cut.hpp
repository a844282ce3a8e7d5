#pragma once
/// \file
/// How the lines of a table are cut into fields.

#include <string>
#include <vector>

namespace plumbline::diagnose {

/// A line that is not empty.
struct Line {
  std::size_t number;  ///< from 0
  std::string text;
  bool comment;
};

/// What a comment may begin with.
const std::vector<std::string>& comment_marks();

std::vector<Line> lines_of(const std::string& text);

/// Fields of a line, without blanks and quotes around them, and without empty ones at the end.
std::vector<std::string> fields_of(const std::string& line, char delimiter);

/// A way to cut lines, and what it gives: rows of as many fields, most of them numbers.
struct Cut {
  char delimiter, decimal;
  std::size_t columns = 0;
  double numbers = 0;         ///< how many fields of the rows are numbers, of all fields of all lines
  std::size_t first_row = 0;  ///< among the lines
  std::size_t end_row = 0;    ///< behind the last one; a footer may follow
};

/// Whether half of the fields are numbers, times by the clock or numbers with a unit.
bool is_row(const std::vector<std::string>& fields, char decimal);

/// The best one; without columns where no way gives rows.
Cut best_cut(const std::vector<Line>& lines);

}  // namespace plumbline::diagnose
