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
        source_(source),
        header_line_(table.header_line == 0 ? source : source + ":" + std::to_string(table.header_line)) {}

  /// Without [columns] two headers are accepted.
  void require_header() const {
    const std::size_t all = format_.place_command1();
    if (!format_.header || table_.header == names(place_q1) || table_.header == names(all)) return;
    throw Error(header_line_, header(),
                "'" + with_commas(names(place_q1)) + "' or '" + with_commas(names(all)) +
                    "', or a table [columns] that says which column is which" + hint());
  }

  [[nodiscard]] std::optional<std::size_t> place(std::size_t c) const {
    const Column& column = format_.columns[c];
    const bool command = c >= format_.place_command1(), angle = c >= place_q1 && !command;
    if (column.constant || (command && !format_.commanded) || (angle && format_.alone != Alone::no))
      return {};
    if (column.number > 0) return numbered(column.number, column.place);
    if (!format_.header && !format_.any_order) return numbered(c + 1, "");  // in the standard order
    return named(column);
  }

  void require_imposed(const ColumnPlaces& places, Control control) const {
    const std::array displacement{place_x, place_y}, force{place_Fx, place_Fy};
    for (const auto c : control == Control::end_point ? displacement : force) {
      const std::string& channel = format_.columns[c].channel;
      if (places[c] || format_.columns[c].constant) continue;
      throw Error(header_line_, "no column '" + channel + "', which the run imposes",
                  "the column, or a key columns." + channel + " that names another" + hint());
    }
  }

  /// Columns of commanded angles have a place where the run imposes them, and are not left out in silence
  /// elsewhere.
  void require_commands(const ColumnPlaces& places) const {
    for (std::size_t c = format_.place_command1(); c < places.size(); ++c) {
      const Column& column = format_.columns[c];
      if (format_.commanded && !places[c])
        throw Error(header_line_, "no column '" + column.channel + "', which the run imposes",
                    "the column, or a key columns.q_command that names another" + hint());
      const auto& header = table_.header;
      if (!format_.commanded && std::find(header.begin(), header.end(), column.name) != header.end())
        throw Error(header_line_, "a column '" + files::shown(column.name) + "' of commanded joint angles",
                    "control = \"command\" in a run that has it");
    }
  }

  void require_angles(const ColumnPlaces& places) const {
    const auto joints = static_cast<std::ptrdiff_t>(format_.joints());
    const auto first = places.begin() + place_q1;
    const auto there = std::count_if(first, first + joints, [](const auto& one) { return one.has_value(); });
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

  [[nodiscard]] std::optional<std::size_t> named(const Column& column) const {
    const auto count = std::count(table_.header.begin(), table_.header.end(), column.name);
    if (count == 0 && column.place.empty()) return {};
    if (count != 1)
      throw Error(header_line_, count == 0 ? header() : std::to_string(count) + " columns of one name",
                  "one column '" + files::shown(column.name) + "'" +
                      (column.place.empty() ? "" : ", which " + column.place + " names") + hint());
    const auto found = std::find(table_.header.begin(), table_.header.end(), column.name);
    return static_cast<std::size_t>(found - table_.header.begin());
  }

  const SampleTable& table_;
  const SampleFormat& format_;
  const std::string& source_;
  std::string header_line_;
};

}  // namespace

ColumnPlaces column_places(const SampleTable& table, const SampleFormat& format, const std::string& source,
                           Control control) {
  const Finder finder(table, format, source);
  if (!format.any_order) finder.require_header();
  ColumnPlaces places;
  for (std::size_t c = 0; c < format.columns.size(); ++c) places.push_back(finder.place(c));
  if (!format.commanded) finder.require_imposed(places, control);
  finder.require_commands(places);
  finder.require_angles(places);
  return places;
}

std::string column_title(const SampleTable& table, std::size_t column) {
  return table.header.empty() ? "column " + std::to_string(column + 1) : table.header[column];
}

}  // namespace plumbline::diagnose
