#include "diagnose/bench/sample_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <plumbline/base/error.hpp>
#include <regex>
#include <set>

#include "diagnose/bench/experiment.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

using SingleChannels = std::array<std::pair<const char*, const Quantity*>, 5>;

/// In the order of their places.
SingleChannels single_channels(Alone alone) {
  using namespace quantity;
  SingleChannels all{{{"t", &time}, {"x", &length}, {"y", &length}, {"Fx", &force}, {"Fy", &force}}};
  if (alone == Alone::turns) all[place_x] = {"angle", &angle}, all[place_Fx] = {"torque", &torque};
  return all;
}

/// That in which joints move.
const Quantity& of_joints(Alone alone) {
  return alone == Alone::slides ? quantity::length : quantity::angle;
}

char delimiter(const Section& csv) {
  const std::string word = csv.one_of("delimiter", {",", ";", "|", "tab", "blanks"});
  if (word == "tab") return '\t';
  return word == "blanks" ? ' ' : word[0];
}

char decimal(const Section& csv) {
  return csv.one_of("decimal", {".", ","})[0];
}

void read_csv(const Section& csv, SampleFormat& format) {
  csv.allow_only({"delimiter", "decimal", "header", "transposed", "skip_lines", "skip_after_header",
                  "comment", "missing"});
  if (csv.has("delimiter")) format.delimiter = delimiter(csv);
  if (csv.has("decimal")) format.decimal = decimal(csv);
  format.header = csv.flag_or("header", format.header);
  format.transposed = csv.flag_or("transposed", format.transposed);
  format.skip_lines = csv.whole_or("skip_lines", format.skip_lines);
  format.skip_after_header = csv.whole_or("skip_after_header", format.skip_after_header);
  if (csv.has("comment")) format.comment = csv.text("comment", "what such lines begin with");
  if (csv.has("missing")) format.missing = csv.texts("missing", "a text, or a list of them");
}

/// A number of experiment.toml as its decimal text.
std::string decimal_text(double value) {
  return fmt::format("{}", value);
}

/// The column of a channel that has its name.
/// \param place  of the key that names it, or empty
Column own_column(const std::string& channel, const Quantity* quantity, const std::string& place) {
  Column column{channel, channel, 0, {}, quantity ? si_unit(*quantity) : Unit{}};
  column.place = place;
  column.quantity = quantity;
  return column;
}

/// A node of one channel: a name, a number, or a table.
class ColumnReader {
 public:
  ColumnReader(const Section& columns, const std::string& key) : columns_(columns), key_(key) {}

  /// \param all  the columns of the key: one, or those of q
  void read(std::vector<Column*> all) const {
    for (Column* column : all) *column = own_column(column->channel, column->quantity, columns_.place(key_));
    const toml::node& node = columns_.node(key_);
    if (node.is_table()) {
      read_table(columns_.table(key_), all);
    } else {
      read_source(columns_, key_, all);
    }
  }

 private:
  /// Whether the key has a column for each joint.
  [[nodiscard]] bool is_list() const { return key_ == "q" || key_ == "q_command"; }

  void read_table(const Section& table, const std::vector<Column*>& all) const {
    std::set<std::string> known{"column", "sign", "zero", is_list() ? "absolute" : "constant"};
    const Quantity* quantity = all.front()->quantity;
    if (quantity) known.insert("unit");
    table.allow_only(known);
    if (table.has("constant")) {
      for (const char* other : {"column", "sign", "zero"})
        if (table.has(other)) table.refuse(other, "nothing beside a constant but its unit");
      all.front()->constant = decimal_text(table.number("constant", "a number"));
    }
    if (table.has("column")) read_source(table, "column", all);
    if (table.has("unit")) {
      const Unit unit = parse_unit(table.text("unit", quantity->examples), *quantity, table.place("unit"));
      for (Column* column : all) column->unit = unit;
    }
    if (table.has("sign")) read_signs(table, all);
    if (table.has("zero")) read_zeros(table, all);
  }

  /// The column of the file: a name of the header, or a number from 1; for joint angles a list of n, or of
  /// one joint the column itself.
  void read_source(const Section& table, const std::string& key, const std::vector<Column*>& all) const {
    const std::string one = "the name of a column, or its number from 1";
    const std::string expected = is_list() ? fmt::format("a list of {}, each {}", all.size(), one) : one;
    const toml::node& node = table.node(key);
    std::vector<const toml::node*> nodes;
    if (const toml::array* list = is_list() ? node.as_array() : nullptr) {
      for (const toml::node& entry : *list) nodes.push_back(&entry);
    } else {
      nodes.push_back(&node);
    }
    if (nodes.size() != all.size()) table.refuse(key, expected);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto number = nodes[i]->value_exact<std::int64_t>();
      const auto name = nodes[i]->value_exact<std::string>();
      if ((!number || *number < 1) && (!name || name->empty())) table.refuse(key, expected);
      all[i]->name = name.value_or("");
      all[i]->number = static_cast<std::size_t>(number.value_or(0));
    }
  }

  static void read_signs(const Section& table, const std::vector<Column*>& all) {
    const std::vector<double> signs = each(table, "sign", all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (signs[i] != 1 && signs[i] != -1) table.refuse("sign", "1 or -1");
      all[i]->sign = signs[i] > 0 ? 1 : -1;
    }
  }

  static void read_zeros(const Section& table, const std::vector<Column*>& all) {
    const toml::node& node = table.node("zero");
    if (node.is_string()) {
      if (node.as_string()->get() != "first") table.refuse("zero", "a number, or \"first\"");
      for (Column* column : all) column->zero_is_first = true;
      return;
    }
    const std::vector<double> zeros = each(table, "zero", all.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i]->zero = decimal_text(zeros[i]);
  }

  /// One number for all, or a list of one for each.
  static std::vector<double> each(const Section& table, const std::string& key, std::size_t count) {
    if (table.node(key).is_array()) return table.numbers(key, count);
    return std::vector<double>(count, table.number(key, "a number, or a list of " + std::to_string(count)));
  }

  const Section& columns_;
  std::string key_;
};

/// The columns of a key with one for each joint.
/// \param first  place of that of joint 1
void read_angles(const Section& columns, const std::string& key, std::size_t first, SampleFormat& format,
                 bool& absolute) {
  if (!columns.has(key)) return;
  std::vector<Column*> angles;
  for (std::size_t i = 0; i < format.joints(); ++i) angles.push_back(&format.columns[first + i]);
  ColumnReader(columns, key).read(angles);
  absolute = columns.node(key).is_table() && columns.table(key).flag_or("absolute", false);
}

/// Whether expressions can have a variable of this name beside their own.
bool can_name_covariate(const std::string& name) {
  static const std::regex form("[A-Za-z][A-Za-z0-9_]{0,39}"), own("[xytsdk]|F[xy](_2)?|torque_2|q[0-9]*|run");
  return std::regex_match(name, form) && !std::regex_match(name, own);
}

void read_covariates(const Section& covariates, SampleFormat& format) {
  for (const std::string& name : covariates.keys()) {
    const auto first = format.columns.begin() + static_cast<std::ptrdiff_t>(format.place_covariate1());
    const auto known =
        std::find_if(first, format.columns.end(), [&](const Column& one) { return one.channel == name; });
    Column& column =
        known == format.columns.end() ? add_covariate(format, name, covariates.place(name)) : *known;
    ColumnReader(covariates, name).read({&column});
  }
}

void read_columns(const Section& columns, SampleFormat& format) {
  const SingleChannels single = single_channels(format.alone);
  const std::set<std::string> all{"t",     "x",      "y",        "Fx",   "Fy",   "q",        "q_command",
                                  "angle", "torque", "torque_2", "Fx_2", "Fy_2", "covariate"};
  columns.allow_only(all);
  for (const std::string& key : all)
    if (columns.has(key) && !has_channel(format.alone, key)) refuse_channel(columns, format.alone, key);
  format.any_order = true;
  for (std::size_t c = 0; c < single.size(); ++c) {
    const char* key = single[c].first;
    if (columns.has(key)) ColumnReader(columns, key).read({&format.columns[c]});
  }
  read_angles(columns, "q", place_q1, format, format.absolute_angles);
  read_angles(columns, "q_command", format.place_command1(), format, format.absolute_commands);
  for (std::size_t c = format.place_second1(); c < format.place_covariate1(); ++c)
    if (const std::string key = format.columns[c].channel; columns.has(key))
      ColumnReader(columns, key).read({&format.columns[c]});
  if (columns.has("covariate")) read_covariates(columns.table("covariate"), format);
}

}  // namespace

bool has_channel(Alone alone, const std::string& key) {
  const bool own = key == "t" || key == "q_command" || key == "covariate";
  switch (alone) {
    case Alone::turns:
      return own || key == "angle" || key == "torque" || key == "torque_2";
    case Alone::slides:
      return own || key == "x" || key == "Fx" || key == "Fx_2";
    case Alone::no:
      break;
  }
  return key != "angle" && key != "torque" && key != "torque_2";
}

void refuse_channel(const Section& section, Alone alone, const std::string& key) {
  section.refuse(key, alone == Alone::no ? "nothing: angle and torque are of a joint alone, nominal.joint"
                      : alone == Alone::turns ? "nothing: a joint that turns has an angle and a torque"
                                              : "nothing: a joint that slides has x and Fx");
}

SampleFormat standard_format(std::size_t joints, Alone alone) {
  SampleFormat format;
  format.alone = alone;
  format.any_order = alone != Alone::no;
  for (const auto& [name, quantity] : single_channels(alone))
    format.columns.push_back(own_column(name, quantity, ""));
  if (alone != Alone::no)
    for (const std::size_t place : {place_y, place_Fy}) format.columns[place].constant = "0";
  for (const char* key : {"q", "q_command"})
    for (std::size_t i = 1; i <= joints; ++i) {
      const std::string name = key + std::to_string(i);
      format.columns.push_back(own_column(name, &of_joints(alone), ""));
    }
  for (const std::size_t place : {place_Fx, place_Fy}) {
    const Column& first = format.columns[place];
    format.columns.push_back(own_column(first.channel + "_2", first.quantity, ""));
  }
  return format;
}

Column& add_covariate(SampleFormat& format, const std::string& name, const std::string& place,
                      const Quantity* quantity) {
  if (!can_name_covariate(name))
    throw Error(place, "\"" + files::shown(name) + "\", a covariate of that name",
                "letters, digits and _, and no variable of expressions such as t, q or Fx");
  if (format.covariates == most_covariates)
    throw Error(place, fmt::format("{} covariates", most_covariates + 1),
                fmt::format("at most {}", most_covariates));
  ++format.covariates;
  return format.columns.emplace_back(own_column(name, quantity, place));
}

SampleFormat read_sample_format(const Section& section, SampleFormat format) {
  if (section.has("csv")) read_csv(section.table("csv"), format);
  if (section.has("columns")) read_columns(section.table("columns"), format);
  return format;
}

SampleFormat read_csv_format(const Section& section) {
  SampleFormat format;
  if (section.has("csv")) read_csv(section.table("csv"), format);
  if (!format.header) section.table("csv").refuse("header", "true: columns are told by their names");
  return format;
}

}  // namespace plumbline::diagnose
