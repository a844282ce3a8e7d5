#include "diagnose/draft/written_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <plumbline/base/error.hpp>
#include <set>

#include "diagnose/draft/cell.hpp"
#include "diagnose/draft/table_cut.hpp"
#include "diagnose/draft/table_header.hpp"

namespace plumbline::diagnose {
namespace {

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

class Guesser {
 public:
  Guesser(const std::string& text, const std::string& source)
      : text_(text), source_(source), lines_(lines_of(text)) {}

  WrittenTable result() {
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
    return all.size() > 1 && cut_.columns > 2 && !table_header(lines_, cut_).names;
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
    const TableHeader header = table_header(lines_, cut_);
    const std::size_t first = lines_[cut_.first_row].number;
    format.header = header.names.has_value();
    if (!header.names) {
      name_by_comment();
      format.skip_lines = plain_lines_above(first);
      if (format.skip_lines > 0)
        say("skip_lines", fmt::format("{}", format.skip_lines), "no row of numbers stands there");
      return;
    }
    const std::size_t line = lines_[*header.names].number;
    format.skip_lines = line;
    format.skip_after_header = first - line - 1;
    result_.names = header.words;
    if (header.units) {
      result_.units = fields(*header.units);
      result_.units.resize(result_.names.size());
    }
    say("header", fmt::format("line {}", line + 1),
        header.units ? "words above the numbers, and a line of units between" : "words above the numbers");
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

  void find_comment() {
    for (const std::string& mark : comment_marks())
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
