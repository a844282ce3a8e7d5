#include "diagnose/bench/sample_columns.hpp"

#include <algorithm>
#include <array>
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

  /// Without [columns] two headers are accepted.
  void require_header() const {
    const std::size_t all = format_.place_command1();
    if (!format_.header || table_.header == names(place_q1) || table_.header == names(all)) return;
    throw Error(header_line_, header(),
                "'" + with_commas(names(place_q1)) + "' or '" + with_commas(names(all)) +
                    "', or a table [columns] that says which column is which" + hint());
  }

  /// \param required  whether a column that experiment.toml names has to be here
  [[nodiscard]] std::optional<std::size_t> place(std::size_t c, bool required) const {
    const Column& column = format_.columns[c];
    const bool command = c >= format_.place_command1() && c < format_.place_second1(),
               second = c >= format_.place_second1() && c < format_.place_covariate1(),
               angle = c >= place_q1 && c < format_.place_command1();
    if (column.constant || (command && !format_.commanded) || (angle && format_.alone != Alone::no))
      return {};
    if (column.number > 0) return numbered(column.number, required ? column.place : "");
    if (second && !format_.header) return {};  // has no place in the standard order
    if (!format_.header && !format_.any_order) return numbered(c + 1, "");  // in the standard order
    return named(column, required);
  }

  /// \param given  by column, whether any part has it
  void require_imposed(const std::vector<bool>& given, Control control) const {
    const std::array displacement{place_x, place_y}, force{place_Fx, place_Fy};
    for (const auto c : control == Control::end_point ? displacement : force) {
      const std::string& channel = format_.columns[c].channel;
      if (given[c]) continue;
      throw Error(header_line_, "no column '" + channel + "', which the run imposes",
                  "the column, or a key columns." + channel + " that names another" + hint());
    }
  }

  /// Columns of commanded angles have a place where the run imposes them, and are not left out in silence
  /// elsewhere.
  void require_commands(const std::vector<bool>& given) const {
    for (std::size_t c = format_.place_command1(); c < format_.place_second1(); ++c) {
      const Column& column = format_.columns[c];
      if (format_.commanded && !given[c])
        throw Error(header_line_, "no column '" + column.channel + "', which the run imposes",
                    "the column, or a key columns.q_command that names another" + hint());
      const auto& header = table_.header;
      if (!format_.commanded && std::find(header.begin(), header.end(), column.name) != header.end())
        throw Error(header_line_, "a column '" + files::shown(column.name) + "' of commanded joint angles",
                    "control = \"command\" in a run that has it");
    }
  }

  void require_angles(const std::vector<bool>& given) const {
    const auto joints = static_cast<std::ptrdiff_t>(format_.joints());
    const auto first = given.begin() + place_q1;
    const auto there = std::count(first, first + joints, true);
    if (there != 0 && there != joints)
      throw Error(header_line_, std::to_string(there) + " columns of joint angles",
                  "all " + std::to_string(joints) + ", or none");
  }

 private:
  [[nodiscard]] std::vector<std::string> names(std::size_t count) const {
    std::vector<std::string> all;
    for (std::size_t c = 0; c < count; ++c) all.push_back(format_.columns[c].channel);
    return all;
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
  first.require_angles(given);
  return all;
}

std::string column_title(const SampleTable& table, std::size_t column) {
  return table.header.empty() ? "column " + std::to_string(column + 1) : table.header[column];
}

}  // namespace plumbline::diagnose
