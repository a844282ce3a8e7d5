#include "diagnose/draft/table_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "diagnose/draft/cell.hpp"

namespace plumbline::diagnose {
namespace {

constexpr std::array delimiters{',', ';', '\t', '|', ' '};

std::string without_blanks(const std::string& field) {
  const std::size_t first = field.find_first_not_of(" \t\r"), last = field.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : field.substr(first, last + 1 - first);
}

/// Fields of the line that names the columns, where a last column has a name and few values.
/// \param counts  rows by their number of fields, empty ones at the end not counted
std::size_t named_columns(const std::vector<Line>& lines, const Cut& cut,
                          const std::vector<std::size_t>& counts) {
  if (cut.delimiter == ' ') return cut.columns;
  for (const Line& line : lines) {
    const std::vector<std::string> all = fields_of(line.text, cut.delimiter);
    if (line.comment) continue;
    if (is_row(all, cut.decimal)) break;
    if (all.size() > cut.columns && all.size() < counts.size() && counts[all.size()] > 0) return all.size();
  }
  return cut.columns;
}

/// Behind the last row: lines that are none end the table where next to no rows follow.
std::size_t end_of_rows(const std::vector<bool>& row, const std::vector<Line>& lines, std::size_t first) {
  constexpr std::size_t few = 10;  // of so many rows one may be in a footer
  std::size_t before = 0, end = first;
  for (std::size_t l = first; l < row.size(); ++l) {
    if (!row[l] && !lines[l].comment) {
      const auto after =
          static_cast<std::size_t>(std::count(row.begin() + static_cast<std::ptrdiff_t>(l), row.end(), true));
      if (few * after <= before) return end;
    }
    if (row[l]) ++before, end = l + 1;
  }
  return end;
}

Cut cut(const std::vector<Line>& lines, char delimiter, char decimal) {
  Cut result{delimiter, decimal};
  std::vector<std::size_t> counts(1);
  std::vector<bool> rows;
  std::size_t fields = 0;
  for (const Line& line : lines) {
    const std::vector<std::string> all = fields_of(line.text, delimiter);
    rows.push_back(!line.comment && is_row(all, decimal));
    if (line.comment) continue;
    fields += std::max<std::size_t>(all.size(), 1);
    if (!rows.back()) continue;
    counts.resize(std::max(counts.size(), all.size() + 1));
    ++counts[all.size()];
  }
  result.columns = static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  result.columns = named_columns(lines, result, counts);
  result.first_row = lines.size();
  double numbers = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const std::vector<std::string> all = fields_of(lines[l].text, delimiter);
    rows[l] = rows[l] && all.size() <= result.columns;
    if (!rows[l]) continue;
    result.first_row = std::min(result.first_row, l);
    for (const std::string& field : all) numbers += std::isnan(cell_of(field, decimal).number) ? 0 : 1;
  }
  result.end_row = end_of_rows(rows, lines, result.first_row);
  result.numbers = fields > 0 ? numbers / static_cast<double>(fields) : 0;
  return result;
}

}  // namespace

const std::vector<std::string>& comment_marks() {
  static const std::vector<std::string> marks{"#", "%", "//"};
  return marks;
}

std::vector<std::string> fields_of(const std::string& line, char delimiter) {
  std::vector<std::string> all;
  if (delimiter == ' ') {
    std::istringstream in(line);
    for (std::string word; in >> word;) all.push_back(word);
    return all;
  }
  all.emplace_back();
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == delimiter && !quoted) {
      all.emplace_back();
    } else if (c != '"') {
      all.back() += c;
    }
  }
  for (std::string& field : all) field = without_blanks(field);
  while (!all.empty() && all.back().empty()) all.pop_back();
  return all;
}

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> all;
  std::istringstream in(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    const bool comment =
        std::any_of(comment_marks().begin(), comment_marks().end(), [&](const std::string& mark) {
          // "%time" is a name, as ROS writes it
          return line.compare(first, mark.size(), mark) == 0 && line.compare(first, 5, "%time") != 0;
        });
    all.push_back({number, line, comment});
  }
  return all;
}

bool is_row(const std::vector<std::string>& fields, char decimal) {
  const auto numbers = std::count_if(fields.begin(), fields.end(), [&](const std::string& field) {
    return !std::isnan(cell_of(field, decimal).number);
  });
  return numbers > 0 && 2 * numbers >= static_cast<std::ptrdiff_t>(fields.size());
}

Cut best_cut(const std::vector<Line>& lines) {
  Cut best{',', '.'};
  // What is cut in two where it need not be has more fields, but numbers that go on without a reason.
  for (const char delimiter : delimiters)
    for (const char decimal : {'.', ','}) {
      if (delimiter == decimal) continue;
      const Cut one = cut(lines, delimiter, decimal);
      constexpr double clearly = 1e-9;
      if (one.columns >= 2 && one.numbers > best.numbers + clearly) best = one;
    }
  return best;
}

}  // namespace plumbline::diagnose
