#include "diagnose/draft/readable_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <plumbline/base/error.hpp>
#include <set>
#include <vector>

#include "diagnose/bench/sample_table.hpp"
#include "diagnose/draft/cell.hpp"
#include "diagnose/draft/column_words.hpp"
#include "diagnose/draft/table_cut.hpp"
#include "diagnose/draft/table_header.hpp"
#include "diagnose/draft/unit_words.hpp"
#include "diagnose/draft/written_table.hpp"
#include "support/files/csv_file.hpp"

namespace plumbline::diagnose {
namespace {

struct Column {
  std::string name;
  std::vector<std::string> fields;
  std::vector<Cell> cells;

  /// How many of its fields are so.
  [[nodiscard]] std::size_t count(const auto& is) const {
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), is));
  }
  [[nodiscard]] std::size_t numbers() const {
    return count([](const Cell& cell) { return !std::isnan(cell.number); });
  }
  [[nodiscard]] std::size_t clocks() const {
    return count([](const Cell& cell) { return cell.clock; });
  }
  /// Whether it has numbers, with strays among them at most.
  [[nodiscard]] bool is_numeric() const {
    const auto said = static_cast<std::size_t>(
        std::count_if(fields.begin(), fields.end(), [](const std::string& field) { return !field.empty(); }));
    return numbers() > 0 && 2 * numbers() >= said;
  }
  /// The unit behind most of its numbers; or empty.
  [[nodiscard]] std::string unit() const {
    std::map<std::string, std::size_t> units;
    for (const Cell& cell : cells)
      if (!cell.unit.empty()) ++units[cell.unit];
    for (const auto& [unit, times] : units)
      if (2 * times > numbers()) return unit;
    return "";
  }
};

/// Whether a column is a time that falls from row to row.
bool goes_back(const std::string& name, const std::vector<double>& numbers) {
  return numbers.size() > 2 && words_of(name, "", {}).kind == Kind::time &&
         std::is_sorted(numbers.rbegin(), numbers.rend()) && numbers.back() < numbers.front();
}

class Rewriting {
 public:
  Rewriting(const std::string& text, const std::string& source, Guesses& guesses)
      : text_(text), source_(source), guesses_(guesses), lines_(lines_of(text)), cut_(best_cut(lines_)) {}

  std::string result() {
    if (cut_.columns < 2 || cut_.first_row == lines_.size() || is_readable()) return text_;
    read_columns();
    take_clocks();
    turn_round();
    take_units();
    return written();
  }

 private:
  void say(const std::string& what, const std::string& value, const std::string& reason) {
    guesses_.push_back({what + " of " + source_, value, reason});
  }

  /// Whether the reader of experiments takes it as it is: rows alone below the header, plain numbers.
  [[nodiscard]] bool is_readable() const {
    for (std::size_t l = cut_.first_row; l < lines_.size(); ++l) {
      if (lines_[l].comment) continue;
      for (const std::string& field : fields_of(lines_[l].text, cut_.delimiter)) {
        const Cell cell = cell_of(field, cut_.decimal);
        if (cell.clock || !cell.unit.empty()) return false;
      }
    }
    try {
      const WrittenTable table = written_table(text_, source_);
      if (table.format.transposed) return true;
      for (std::size_t c = 0; c < table.names.size(); ++c)
        if (goes_back(table.names[c], table.numbers(c))) return false;
      return !table_header(lines_, cut_).several_lines && !has_other_lines() &&
             !has_column_of_units(table.names);
    } catch (const Error&) {
      return false;
    }
  }

  [[nodiscard]] bool is_row_at(std::size_t line) const {
    return !lines_[line].comment && is_row(fields_of(lines_[line].text, cut_.delimiter), cut_.decimal);
  }
  [[nodiscard]] bool has_other_lines() const {
    for (std::size_t l = cut_.first_row; l < lines_.size(); ++l)
      if (!lines_[l].comment && (l >= cut_.end_row || !is_row_at(l))) return true;
    return false;
  }

  static bool is_word_unit(const std::string& name) {
    static const std::set<std::string> words{"unit",   "units",        "einheit",     "unite",
                                             "unidad", "\u5355\u4f4d", "\u5358\u4f4d"};
    return words.contains(folded(name));
  }
  static bool has_column_of_units(const std::vector<std::string>& names) {
    return std::any_of(names.begin(), names.end(), is_word_unit);
  }

  void read_columns() {
    const TableHeader header = table_header(lines_, cut_);
    std::vector<std::string> units;
    if (header.units) units = fields_of(lines_[*header.units].text, cut_.delimiter);
    columns_.resize(std::max(cut_.columns, header.words.size()));
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      columns_[c].name = c < header.words.size() ? header.words[c] : "";
      if (c < units.size() && !units[c].empty() && units[c] != "hh:mm:ss")
        columns_[c].name += " [" + units[c] + "]";
    }
    named_ = header.names.has_value();
    std::size_t left_out = 0;
    for (std::size_t l = cut_.first_row; l < lines_.size(); ++l) {
      if (lines_[l].comment) continue;
      std::vector<std::string> fields = fields_of(lines_[l].text, cut_.delimiter);
      if (l >= cut_.end_row || !is_row_at(l) || fields.size() > columns_.size()) {
        ++left_out;
        continue;
      }
      fields.resize(columns_.size());
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        columns_[c].cells.push_back(cell_of(fields[c], cut_.decimal));
        columns_[c].fields.push_back(std::move(fields[c]));
      }
    }
    if (left_out > 0) say("lines left out", fmt::format("{}", left_out), "they are no rows of numbers");
  }

  void take_clocks() {
    constexpr double day = 86400;
    for (Column& column : columns_) {
      if (2 * column.clocks() <= column.fields.size()) continue;
      double midnights = 0, before = NAN;
      for (Cell& cell : column.cells) {
        if (!cell.dated && cell.number < before - day / 2) midnights += day;
        before = cell.number;
        if (!cell.dated) cell.number += midnights;
      }
      say("clock", column.name.empty() ? "seconds" : column.name + ", in s",
          "times by the clock, taken as seconds");
      column.name = column.name.empty() ? "" : column.name + " [s]";
    }
  }

  /// Some loggers write the newest line first.
  void turn_round() {
    for (const Column& column : columns_) {
      std::vector<double> times;
      for (const Cell& cell : column.cells) times.push_back(cell.number);
      if (!goes_back(column.name, times)) continue;
      say("rows", "turned round", fmt::format("the times of {} fall", column.name));
      for (Column& one : columns_) {
        std::reverse(one.cells.begin(), one.cells.end());
        std::reverse(one.fields.begin(), one.fields.end());
      }
      return;
    }
  }

  void take_units() {
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      Column& column = columns_[c];
      if (const std::string unit = column.unit(); !unit.empty() && !column.name.empty()) {
        say("unit", fmt::format("{}, in {}", column.name, unit), "it stands behind the numbers");
        column.name += " [" + unit + "]";
      }
      if (c == 0 || !is_word_unit(column.name) || column.fields.empty()) continue;
      const std::string& unit = column.fields.front();
      if (std::count(column.fields.begin(), column.fields.end(), unit) !=
          static_cast<std::ptrdiff_t>(column.fields.size()))
        continue;
      Column& before = columns_[c - 1];
      say("unit", fmt::format("{}, in {}", before.name, unit), "the column beside it says so in every line");
      before.name += " [" + unit + "]";
    }
  }

  [[nodiscard]] std::string field_of(const Column& column, std::size_t row) const {
    if (!column.is_numeric()) return files::csv_field(column.fields[row]);
    const Cell& cell = column.cells[row];
    if (std::isnan(cell.number)) return "";
    if (cell.clock) return fmt::format("{:.6f}", cell.number);
    // the digits that were written, not a double's
    std::string digits = column.fields[row];
    if (!cell.unit.empty()) digits.erase(digits.find_last_of("0123456789") + 1);
    std::replace(digits.begin(), digits.end(), ',', '.');
    return digits;
  }

  [[nodiscard]] std::string written() {
    std::string text;
    if (named_) {
      std::vector<std::string> names;
      while (columns_.back().name.empty() && columns_.back().numbers() == 0) columns_.pop_back();
      for (const Column& column : columns_) names.push_back(files::csv_field(column.name));
      text = fmt::format("{}\n", fmt::join(names, ","));
    }
    for (std::size_t row = 0; row < columns_.front().fields.size(); ++row) {
      std::vector<std::string> fields;
      for (const Column& column : columns_) fields.push_back(field_of(column, row));
      text += fmt::format("{}\n", fmt::join(fields, ","));
    }
    say("table", "written anew", "the readings are in it as they were, with commas and a decimal point");
    return text;
  }

  const std::string& text_;
  const std::string& source_;
  Guesses& guesses_;
  std::vector<Line> lines_;
  Cut cut_;
  std::vector<Column> columns_;
  bool named_ = false;
};

}  // namespace

std::string readable_table(const std::string& text, const std::string& source, Guesses& guesses) {
  return Rewriting(text, source, guesses).result();
}

}  // namespace plumbline::diagnose
