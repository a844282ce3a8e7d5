#include "diagnose/draft/written_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <set>
#include <sstream>

namespace plumbline::diagnose {
namespace {

constexpr std::array delimiters{',', ';', '\t', '|', ' '};
constexpr std::array comments{"#", "%", "//"};

std::string word_of(char delimiter) {
  switch (delimiter) {
    case '\t':
      return "tab";
    case ' ':
      return "blanks";
    default:
      return std::string(1, delimiter);
  }
}

double number_of(std::string text, char decimal) {
  if (decimal == ',' && text.find('.') != std::string::npos) return NAN;
  if (decimal == ',') std::replace(text.begin(), text.end(), ',', '.');
  if (text.starts_with('+')) text.erase(0, 1);
  double value = NAN;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  return !text.empty() && fault == std::errc() && stop == end && std::isfinite(value) ? value : NAN;
}

/// Fields of a line, without blanks and quotes around them.
std::vector<std::string> fields_of(const std::string& line, char delimiter) {
  std::vector<std::string> all;
  std::istringstream in(line);
  if (delimiter == ' ') {
    for (std::string word; in >> word;) all.push_back(word);
    return all;
  }
  for (std::string field; std::getline(in, field, delimiter);) {
    const std::size_t first = field.find_first_not_of(" \t\r\""), last = field.find_last_not_of(" \t\r\"");
    all.push_back(first == std::string::npos ? "" : field.substr(first, last + 1 - first));
  }
  while (!all.empty() && all.back().empty()) all.pop_back();
  return all;
}

struct Line {
  std::size_t number;  ///< from 0
  std::string text;
  bool comment;
};

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> all;
  std::istringstream in(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line); ++number) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos) continue;
    const bool comment = std::any_of(comments.begin(), comments.end(), [&](const char* mark) {
      return line.compare(first, std::string(mark).size(), mark) == 0;
    });
    all.push_back({number, line, comment});
  }
  return all;
}

/// A way to cut lines, and what it gives: rows of as many fields, most of them numbers.
struct Cut {
  char delimiter, decimal;
  std::size_t columns = 0;
  double numbers = 0;         ///< how many fields of the rows are numbers, of all fields of all lines
  std::size_t first_row = 0;  ///< among the lines
};

bool is_row(const std::vector<std::string>& fields, char decimal) {
  const auto numbers = std::count_if(fields.begin(), fields.end(), [&](const std::string& field) {
    return !std::isnan(number_of(field, decimal));
  });
  return numbers > 0 && 2 * numbers >= static_cast<std::ptrdiff_t>(fields.size());
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

Cut cut(const std::vector<Line>& lines, char delimiter, char decimal) {
  Cut result{delimiter, decimal};
  std::vector<std::size_t> counts(1);
  std::size_t fields = 0;
  for (const Line& line : lines) {
    const std::vector<std::string> all = fields_of(line.text, delimiter);
    if (line.comment) continue;
    fields += std::max<std::size_t>(all.size(), 1);
    if (!is_row(all, decimal)) continue;
    counts.resize(std::max(counts.size(), all.size() + 1));
    ++counts[all.size()];
  }
  result.columns = static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  result.columns = named_columns(lines, result, counts);
  result.first_row = lines.size();
  double numbers = 0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const std::vector<std::string> all = fields_of(lines[l].text, delimiter);
    if (lines[l].comment || !is_row(all, decimal) || all.size() > result.columns) continue;
    result.first_row = std::min(result.first_row, l);
    for (const std::string& field : all) numbers += std::isnan(number_of(field, decimal)) ? 0 : 1;
  }
  result.numbers = fields > 0 ? numbers / static_cast<double>(fields) : 0;
  return result;
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

class Guesser {
 public:
  Guesser(const std::string& text, const std::string& source)
      : text_(text), source_(source), lines_(lines_of(text)) {}

  WrittenTable result() {
    if (text_.starts_with("PK\x03\x04"))  // a zip archive, as workbooks are
      throw Error(source_, "a workbook",
                  "text in columns; in the Python package `plumbline new` reads workbooks");
    cut_ = best_cut(lines_);
    if (cut_.columns < 2)
      throw Error(source_, "no rows of numbers", "a table with a column for each quantity, a row a reading");
    SampleFormat& format = result_.format;
    format.delimiter = cut_.delimiter;
    format.decimal = cut_.decimal;
    say("delimiter", word_of(cut_.delimiter),
        fmt::format("it cuts the rows into {} fields alike", cut_.columns));
    if (cut_.decimal == ',') say("decimal", ",", "numbers are written as 0,5");
    if (is_transposed()) {
      take_lines_as_columns();
    } else {
      find_header();
    }
    find_comment();
    find_missing();
    result_.table = parse_sample_table(text_, source_, format);
    return std::move(result_);
  }

 private:
  void say(const std::string& what, const std::string& value, const std::string& reason) {
    result_.guesses.push_back({what, value, reason});
  }
  [[nodiscard]] std::vector<std::string> fields(std::size_t line) const {
    return fields_of(lines_[line].text, cut_.delimiter);
  }
  /// Whether a line above the rows has a word for each column, or for all but the last.
  [[nodiscard]] bool is_header(const Line& line) const {
    const std::size_t count = fields_of(line.text, cut_.delimiter).size();
    return !line.comment && count + 1 >= cut_.columns && count <= cut_.columns;
  }

  /// Fields of the lines that are no comments, from the first row on.
  [[nodiscard]] std::vector<std::vector<std::string>> rows() const {
    std::vector<std::vector<std::string>> all;
    for (std::size_t l = cut_.first_row; l < lines_.size(); ++l)
      if (!lines_[l].comment) all.push_back(fields(l));
    return all;
  }

  /// Whether every line is a name of its own and numbers, with no other names above.
  [[nodiscard]] bool is_transposed() const {
    std::set<std::string> names;
    const auto all = rows();
    for (const std::vector<std::string>& row : all) {
      if (row.size() < 2 || row.size() > cut_.columns || row[0].empty()) return false;
      const auto letter = static_cast<unsigned char>(row[0].front());
      if ((letter < 0x80 && std::isalpha(letter) == 0) || !names.insert(row[0]).second) return false;
    }
    const bool header =
        std::any_of(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(cut_.first_row),
                    [&](const Line& line) { return is_header(line); });
    return all.size() > 1 && cut_.columns > 2 && !header;
  }

  void take_lines_as_columns() {
    SampleFormat& format = result_.format;
    format.transposed = true;
    format.skip_lines = plain_lines_above(lines_[cut_.first_row].number);
    for (const std::vector<std::string>& row : rows()) result_.names.push_back(row[0]);
    say("transposed", "each line is a column",
        "every line begins with a name of its own, and numbers follow");
  }

  /// Above the rows: the header, the line of units below it, and what is to be passed over.
  void find_header() {
    SampleFormat& format = result_.format;
    format.header = false;
    std::vector<std::size_t> above;
    for (std::size_t l = 0; l < cut_.first_row; ++l)
      if (is_header(lines_[l])) above.push_back(l);
    const std::size_t first = lines_[cut_.first_row].number;
    if (above.empty()) {
      name_by_comment();
      format.skip_lines = plain_lines_above(first);
      if (format.skip_lines > 0)
        say("skip_lines", fmt::format("{}", format.skip_lines), "no row of numbers stands there");
      return;
    }
    format.header = true;
    const std::size_t header =
        above.size() > 1 && looks_like_units(above.back()) ? above[above.size() - 2] : above.back();
    format.skip_lines = lines_[header].number;
    format.skip_after_header = first - lines_[header].number - 1;
    result_.names = fields(header);
    result_.names.resize(cut_.columns);
    if (header != above.back()) {
      result_.units = fields(above.back());
      result_.units.resize(cut_.columns);
    }
    say("header", fmt::format("line {}", lines_[header].number + 1),
        format.skip_after_header > 0 ? "words above the numbers, and a line of units between"
                                     : "words above the numbers");
  }

  /// Lines before the first row that are no comments.
  [[nodiscard]] std::size_t plain_lines_above(std::size_t first) const {
    return std::any_of(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(cut_.first_row),
                       [](const Line& line) { return !line.comment; })
               ? first
               : 0;
  }

  /// As NumPy writes it: "# t x y Fx Fy".
  void name_by_comment() {
    for (std::size_t l = 0; l < cut_.first_row; ++l) {
      if (!lines_[l].comment) continue;
      const std::size_t first = lines_[l].text.find_first_not_of(" \t#%/");
      if (first == std::string::npos) continue;  // a line of comment marks
      const std::string text = lines_[l].text.substr(first);
      for (const char delimiter : {cut_.delimiter, ' ', ','}) {
        const std::vector<std::string> words = fields_of(text, delimiter);
        if (words.size() != cut_.columns) continue;
        result_.names = words;
        say("columns", "named by the comment above the rows", fmt::format("it has {} words", cut_.columns));
        break;
      }
    }
  }

  [[nodiscard]] bool looks_like_units(std::size_t line) const {
    const std::vector<std::string> all = fields(line);
    return std::all_of(all.begin(), all.end(), [](const std::string& one) {
      constexpr std::size_t longest = 10;
      return one.size() <= longest;
    });
  }

  void find_comment() {
    for (const char* mark : comments)
      for (const Line& line : lines_)
        if (line.comment && line.text.find_first_not_of(" \t") == line.text.find(mark) &&
            result_.format.comment.empty()) {
          result_.format.comment = mark;
          say("comment", mark, fmt::format("line {} begins with it", line.number + 1));
        }
  }

  /// Words that stand among numbers.
  void find_missing() {
    std::set<std::string> words;
    std::vector<std::size_t> numeric(cut_.columns), rows(cut_.columns);
    const auto each = [&](const auto& look) {
      for (std::size_t l = cut_.first_row; l < lines_.size(); ++l) {
        const std::vector<std::string> all = fields(l);
        for (std::size_t c = 0; !lines_[l].comment && c < std::min(all.size(), cut_.columns); ++c)
          look(c, all[c]);
      }
    };
    each([&](std::size_t c, const std::string& field) {
      ++rows[c];
      if (!std::isnan(number_of(field, cut_.decimal))) ++numeric[c];
    });
    each([&](std::size_t c, const std::string& field) {
      if (2 * numeric[c] > rows[c] && !field.empty() && std::isnan(number_of(field, cut_.decimal)))
        words.insert(field);
    });
    constexpr std::size_t most = 5;
    if (words.empty() || words.size() > most) return;
    result_.format.missing.assign(words.begin(), words.end());
    say("missing", fmt::format("{}", fmt::join(words, ", ")), "they stand among numbers");
  }

  const std::string& text_;
  const std::string& source_;
  std::vector<Line> lines_;
  Cut cut_{',', '.'};
  WrittenTable result_;
};

}  // namespace

std::vector<double> WrittenTable::numbers(std::size_t column) const {
  std::vector<double> all;
  for (const files::CsvRow& row : table.rows) all.push_back(number_of(row.fields[column], format.decimal));
  return all;
}

WrittenTable written_table(const std::string& text, const std::string& source) {
  return Guesser(text, source).result();
}

}  // namespace plumbline::diagnose
