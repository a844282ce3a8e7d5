#include "diagnose/bench/sample_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <plumbline/base/error.hpp>
#include <regex>
#include <set>

#include "diagnose/bench/experiment.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {

const Quantity& quantity_of(Sensor sensor) {
  switch (sensor) {
    case Sensor::position:
    case Sensor::distance:
      return quantity::length;
    case Sensor::pixel:
      return quantity::pixel;
    case Sensor::force:
    case Sensor::second_force:
      return quantity::force;
    case Sensor::torque:
    case Sensor::second_torque:
      return quantity::torque;
    case Sensor::angle:
    case Sensor::orientation:
      break;
  }
  return quantity::angle;
}

namespace {

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

/// A node of one channel: a name, a number, or a table.
class ColumnReader {
 public:
  ColumnReader(const Section& columns, const std::string& key) : columns_(columns), key_(key) {}

  /// \param all  the columns of the key: one, or those of q
  void read(std::vector<Column*> all) const {
    for (Column* column : all) {
      Column own = own_column(column->channel, column->quantity, columns_.place(key_));
      own.says = column->says, own.reads = column->reads, own.group = column->group;
      own.unit = own.usual_unit = column->usual_unit;
      *column = std::move(own);
    }
    const toml::node& node = columns_.node(key_);
    if (node.is_table()) {
      read_table(columns_.table(key_), all);
    } else {
      read_source(columns_, key_, all);
    }
  }

 private:
  void read_table(const Section& table, const std::vector<Column*>& all) const {
    const bool is_list = !all.front()->group.empty();
    std::set<std::string> known{"column", "sign", "zero", is_list ? "absolute" : "constant"};
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
    const bool is_list = !all.front()->group.empty();
    const std::string expected = is_list ? fmt::format("a list of {}, each {}", all.size(), one) : one;
    const toml::node& node = table.node(key);
    std::vector<const toml::node*> nodes;
    if (const toml::array* list = is_list ? node.as_array() : nullptr) {
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

/// Whether expressions can have a variable of this name beside their own.
bool can_name_covariate(const std::string& name) {
  static const std::regex form("[A-Za-z][A-Za-z0-9_]{0,39}"), own("[xytsdk]|F[xy](_2)?|torque_2|q[0-9]*|run");
  return std::regex_match(name, form) && !std::regex_match(name, own);
}

void read_covariates(const Section& covariates, SampleFormat& format) {
  for (const std::string& name : covariates.keys()) {
    const auto known = std::ranges::find_if(format.columns, [&](const Column& one) {
      return one.says == Says::covariate && one.channel == name;
    });
    Column& column =
        known == format.columns.end() ? add_covariate(format, name, covariates.place(name)) : *known;
    ColumnReader(covariates, name).read({&column});
  }
}

void read_columns(const Section& columns, SampleFormat& format) {
  std::set<std::string> own{format.all_known ? "ignore" : "covariate"};
  for (const Column& column : format.columns)
    if (column.says != Says::covariate || format.all_known) own.insert(column.key());
  require_keys(columns, format, own);
  if (columns.has("ignore")) format.ignored = columns.texts("ignore", "names of columns");
  format.any_order = true;
  std::map<std::string, std::vector<Column*>> by_key;
  for (Column& column : format.columns)
    if (own.contains(column.key())) by_key[column.key()].push_back(&column);
  for (const auto& [key, named] : by_key)
    if (columns.has(key)) ColumnReader(columns, key).read(named);
  const auto are_absolute = [&](const char* key) {
    return columns.has(key) && columns.node(key).is_table() && columns.table(key).flag_or("absolute", false);
  };
  if (columns.has("q")) format.absolute_angles = are_absolute("q");
  if (columns.has("q_command")) format.absolute_commands = are_absolute("q_command");
  if (columns.has("covariate")) read_covariates(columns.table("covariate"), format);
}

/// The column of a channel in the unit of its kind.
Column channel_column(const Channel& channel, const Quantity& quantity) {
  Column column = own_column(channel.label(), &quantity);
  column.says = Says::channel, column.reads = channel;
  if (channel.kind().index == ChannelKind::Index::joint) column.group = channel.kind().label;
  return column;
}

}  // namespace

std::size_t SampleFormat::covariates() const {
  return static_cast<std::size_t>(std::ranges::count(columns, Says::covariate, &Column::says));
}

void require_keys(const Section& section, const SampleFormat& format, const std::set<std::string>& own) {
  std::set<std::string> all = own;
  if (!format.all_known)
    for (const Channel& channel : end_channels()) all.insert(channel.label());
  if (!format.all_known) all.insert("q");
  section.allow_only(all);
  for (const std::string& key : section.keys())
    if (!own.contains(key)) section.refuse(key, std::string(format.end().has_others));
}

Column own_column(const std::string& channel, const Quantity* quantity, const std::string& place) {
  const Unit unit = quantity ? si_unit(*quantity) : Unit{};
  Column column{channel, channel, 0, {}, unit, unit};
  column.place = place;
  column.quantity = quantity;
  return column;
}

SampleFormat standard_format(std::size_t joints, Device device) {
  SampleFormat format;
  format.device = device;
  const EndKind& end = format.end();
  format.any_order = !end.has_links;
  format.columns.push_back(own_column("t", &quantity::time));
  format.columns.back().says = Says::time;
  for (const auto& channels : {end.place, end.load})
    for (const Channel& channel : channels)
      format.columns.push_back(channel_column(channel, quantity_of(channel.sensor())));
  if (end.joint_angles)
    for (std::size_t j = 0; j < joints; ++j)
      format.columns.push_back(channel_column(Channel(Channel::Name::q, j), quantity::angle));
  for (std::size_t j = 0; j < joints; ++j) {
    format.columns.push_back(own_column("q_command" + std::to_string(j + 1), &quantity_of(end.joint)));
    format.columns.back().says = Says::command, format.columns.back().group = "q_command";
  }
  for (const Channel& channel : end.second)
    format.columns.push_back(channel_column(channel, quantity_of(channel.sensor())));
  for (const ChannelKind& kind : channel_kinds)
    for (std::size_t j = 0; end.joint_angles && kind.of == ChannelKind::Of::chain && j < joints; ++j)
      format.columns.push_back(channel_column(Channel(kind.name, j, joints), quantity_of(kind.sensor)));
  return format;
}

Column& add_covariate(SampleFormat& format, const std::string& name, const std::string& place,
                      const Quantity* quantity) {
  if (!can_name_covariate(name))
    throw Error(place, "\"" + files::shown(name) + "\", a covariate of that name",
                "letters, digits and _, and no variable of expressions such as t, q or Fx");
  if (format.covariates() == most_covariates)
    throw Error(place, fmt::format("{} covariates", most_covariates + 1),
                fmt::format("at most {}", most_covariates));
  return format.columns.emplace_back(own_column(name, quantity, place));
}

SampleFormat read_sample_format(const Section& section, SampleFormat format) {
  if (section.has("csv")) read_csv(section.table("csv"), format);
  if (section.has("columns")) read_columns(section.table("columns"), format);
  return format;
}

}  // namespace plumbline::diagnose
