#include "diagnose/bench/sample_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

std::string with_commas(const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& field : fields) text += (text.empty() ? "" : ",") + field;
  return text;
}

class Finder {
 public:
  Finder(const SampleTable& table, const SampleFormat& format, const std::string& source)
      : table_(table),
        format_(format),
        header_line_(table.header_line == 0 || table.transposed
                         ? source
                         : source + ":" + std::to_string(table.header_line)) {}

  /// Without [columns] two headers are accepted: with the joints' angles and without.
  void require_header() const {
    std::vector<std::string> few, all;
    for (const Column& column : format_.columns) {
      if (column.says != Says::time && !in_standard_order(column)) continue;
      if (column.group.empty()) few.push_back(column.channel);
      all.push_back(column.channel);
    }
    if (!format_.header || table_.header == few || table_.header == all) return;
    throw Error(header_line_, header(),
                "'" + with_commas(few) + "' or '" + with_commas(all) +
                    "', or a table [columns] that says which column is which" + hint());
  }

  /// \throws Error for a column of no meaning
  void require_known() const {
    if (!format_.all_known) return;
    std::string names;
    for (const Column& column : format_.columns) names += (names.empty() ? "" : ", ") + column.name;
    for (const std::string& name : table_.header) {
      if (std::ranges::count(table_.header, name) > 1)
        throw Error(header_line_, "two columns '" + files::shown(name) + "'", "names that differ");
      if (std::ranges::count(format_.columns, name, &Column::name) == 0 &&
          std::ranges::count(format_.ignored, name) == 0)
        throw Error(header_line_, "a column '" + files::shown(name) + "'",
                    names + "; or columns.ignore = [\"" + files::shown(name) + "\"]");
    }
  }

  /// \param required  whether a column that experiment.toml names has to be here
  [[nodiscard]] std::optional<std::size_t> place(std::size_t c, bool required) const {
    const Column& column = format_.columns[c];
    if (column.constant || (column.says == Says::command && !format_.commanded)) return {};
    if (column.number > 0) return numbered(column.number, required ? column.place : "");
    if (column.says == Says::channel && !in_standard_order(column) && !format_.header) return {};
    if (!format_.header && !format_.any_order) return numbered(c + 1, "");
    return named(column, required);
  }

  /// \param given  by column, whether any part has it
  void require_imposed(const std::vector<bool>& given, Control control) const {
    const EndKind& end = format_.end();
    for (std::size_t c = 0; c < given.size(); ++c) {
      const std::string& channel = format_.columns[c].channel;
      if (given[c] || !format_.columns[c].reads_any(control == Control::end_point ? end.place : end.load))
        continue;
      throw Error(header_line_, "no column '" + channel + "', which the run imposes",
                  "the column, or a key columns." + channel + " that names another" + hint());
    }
  }

  /// Columns of commanded angles have a place where the run imposes them, and are not left out in silence
  /// elsewhere.
  void require_commands(const std::vector<bool>& given) const {
    for (std::size_t c = 0; c < given.size(); ++c) {
      const Column& column = format_.columns[c];
      if (column.says != Says::command) continue;
      if (format_.commanded && !given[c])
        throw Error(header_line_, "no column '" + column.channel + "', which the run imposes",
                    "the column, or a key columns.q_command that names another" + hint());
      const auto& header = table_.header;
      if (!format_.commanded && std::find(header.begin(), header.end(), column.name) != header.end())
        throw Error(header_line_, "a column '" + files::shown(column.name) + "' of commanded joint angles",
                    "control = \"command\" in a run that has it");
    }
  }

  /// Columns of one group are there together or not at all.
  void require_groups(const std::vector<bool>& given) const {
    for (const Column& one : format_.columns) {
      std::size_t all = 0, there = 0;
      std::string names;
      for (std::size_t c = 0; c < given.size(); ++c) {
        if (one.group.empty() || format_.columns[c].group != one.group) continue;
        ++all, there += given[c];
        names += (names.empty() ? "" : ", ") + format_.columns[c].name;
      }
      if (there != 0 && there != all)
        throw Error(header_line_, fmt::format("{} of the columns {}", there, files::shown(names)),
                    fmt::format("all {}, or none", all));
    }
  }

 private:
  /// Whether a file without [columns] has it: the end point, its load and the joints' angles.
  [[nodiscard]] bool in_standard_order(const Column& column) const {
    const EndKind& end = format_.end();
    return column.reads_any(end.place) || column.reads_any(end.load) || column.group == "q";
  }

  [[nodiscard]] std::string header() const {
    return format_.header ? "the header '" + files::shown(with_commas(table_.header)) + "'" : "no header";
  }

  [[nodiscard]] std::string hint() const { return other_delimiter(table_, format_); }

  [[nodiscard]] std::optional<std::size_t> numbered(std::size_t number, const std::string& key) const {
    const std::size_t columns = table_.rows.front().fields.size();
    if (number <= columns) return number - 1;
    if (key.empty()) return {};
    throw Error(header_line_, std::to_string(columns) + " columns",
                "a column " + std::to_string(number) + ", which " + key + " names" + hint());
  }

  [[nodiscard]] std::optional<std::size_t> named(const Column& column, bool required) const {
    const auto count = std::count(table_.header.begin(), table_.header.end(), column.name);
    if (count == 0 && (column.place.empty() || !required)) return {};
    if (count != 1)
      throw Error(header_line_, count == 0 ? header() : std::to_string(count) + " columns of one name",
                  "one column '" + files::shown(column.name) + "'" +
                      (column.place.empty() ? "" : ", which " + column.place + " names") +
                      (count == 0 ? hint() : "; a number says which one"));
    const auto found = std::find(table_.header.begin(), table_.header.end(), column.name);
    return static_cast<std::size_t>(found - table_.header.begin());
  }

  const SampleTable& table_;
  const SampleFormat& format_;
  std::string header_line_;
};

}  // namespace

std::vector<ColumnPlaces> column_places(const std::vector<SamplePart>& parts, Control control) {
  const bool alone = parts.size() == 1;
  std::vector<ColumnPlaces> all(parts.size());
  const std::size_t count = parts.front().format.columns.size();
  std::vector<bool> given(count);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Finder finder(parts[p].table, parts[p].format, parts[p].source);
    if (alone && !parts[p].format.any_order) finder.require_header();
    finder.require_known();
    for (std::size_t c = 0; c < count; ++c) {
      all[p].push_back(finder.place(c, alone));
      if (all[p][c] || parts[p].format.columns[c].constant) given[c] = true;
    }
  }
  const Finder first(parts.front().table, parts.front().format, parts.front().source);
  for (std::size_t c = 0; c < count; ++c)
    if (!given[c]) static_cast<void>(first.place(c, true));
  if (!parts.front().format.free_end) first.require_imposed(given, control);
  first.require_commands(given);
  first.require_groups(given);
  return all;
}

std::string column_title(const SampleTable& table, std::size_t column) {
  return table.header.empty() ? "column " + std::to_string(column + 1) : table.header[column];
}

}  // namespace plumbline::diagnose
