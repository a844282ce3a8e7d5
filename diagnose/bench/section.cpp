#include "diagnose/bench/section.hpp"

#include <fmt/format.h>

#include <cmath>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "files/printable.hpp"

namespace plumbline::diagnose {
namespace {

double number(const toml::node& node, const std::string& place, const std::string& expected) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !std::isfinite(*value)) throw Error(place, shown(node), expected);
  return *value;
}

}  // namespace

std::string shown(const toml::node& node) {
  if (const auto* value = node.as_floating_point()) return fmt::format("{}", value->get());
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return files::shown(text.str());
}

void Section::allow_only(const std::set<std::string>& keys) const {
  for (const auto& [key, value] : table_) {
    if (keys.contains(std::string(key.str()))) continue;
    std::string expected = "one of";
    for (const std::string& known : keys) expected += " " + known;
    throw Error(place(files::shown(key.str())), "an unknown key", expected);
  }
}

const toml::node& Section::required(const std::string& key, const std::string& expected) const {
  const toml::node* node = table_.get(key);
  if (node == nullptr) throw Error(place(key), "no such key", expected);
  return *node;
}

Section Section::table(const std::string& key) const {
  const toml::node& node = required(key, "a table [" + key + "]");
  if (!node.is_table()) throw Error(place(key), shown(node), "a table [" + key + "]");
  return {*node.as_table(), place(key) + "."};
}

std::vector<Section> Section::tables(const std::string& key) const {
  std::vector<Section> all;
  if (!has(key)) return all;
  const toml::node& node = *table_.get(key);
  if (!node.is_array() || !node.as_array()->is_homogeneous(toml::node_type::table))
    throw Error(place(key), shown(node), "tables [[" + key + "]]");
  for (const toml::node& entry : *node.as_array())
    all.emplace_back(*entry.as_table(), place(key + "[" + std::to_string(all.size() + 1) + "]."));
  return all;
}

std::string Section::text(const std::string& key, const std::string& expected) const {
  const toml::node& node = required(key, expected);
  if (!node.is_string() || node.as_string()->get().empty()) throw Error(place(key), shown(node), expected);
  files::require_printable(node.as_string()->get(), place(key));
  return node.as_string()->get();
}

double Section::non_negative(const std::string& key) const {
  if (!has(key)) return 0;
  const std::string expected = "a number, zero or positive";
  const double value = number(required(key, expected), place(key), expected);
  if (value < 0) throw Error(place(key), shown(*table_.get(key)), expected);
  return value;
}

std::size_t Section::count(const std::string& key) const {
  if (!has(key)) return 0;
  const toml::node& node = *table_.get(key);
  const std::optional<std::int64_t> value =
      node.is_integer() ? node.value<std::int64_t>() : std::optional<std::int64_t>();
  if (!value || *value < 1) throw Error(place(key), shown(node), "an integer from 1");
  return static_cast<std::size_t>(*value);
}

std::vector<double> Section::numbers(const std::string& key, std::size_t length) const {
  const std::string expected =
      length == 0 ? std::string("a list of numbers") : "a list of " + std::to_string(length) + " numbers";
  const toml::node& node = required(key, expected);
  if (!node.is_array()) throw Error(place(key), shown(node), expected);
  const toml::array& list = *node.as_array();
  if (list.empty() || (length != 0 && list.size() != length))
    throw Error(place(key), std::to_string(list.size()) + " values", expected);
  std::vector<double> values;
  for (const toml::node& entry : list)
    values.push_back(
        number(entry, place(key) + "[" + std::to_string(values.size() + 1) + "]", "a finite number"));
  return values;
}

std::vector<double> Section::numbers(const std::string& key, std::size_t length, const std::string& expected,
                                     bool (*accept)(double)) const {
  std::vector<double> values = numbers(key, length);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (accept(values[i])) continue;
    throw Error(place(key) + "[" + std::to_string(i + 1) + "]", fmt::format("{}", values[i]), expected);
  }
  return values;
}

std::array<double, 2> Section::pair(const std::string& key) const {
  const std::vector<double> values = numbers(key, 2);
  return {values[0], values[1]};
}

std::map<std::string, double> Section::named_numbers(const std::string& key) const {
  const std::string expected = "a table of numbers";
  const toml::node& node = required(key, expected);
  if (!node.is_table()) throw Error(place(key), shown(node), expected);
  std::map<std::string, double> values;
  for (const auto& [name, value] : *node.as_table()) {
    const std::string own(name.str());
    values[own] = number(value, place(key) + "." + files::shown(own), "a finite number");
  }
  return values;
}

}  // namespace plumbline::diagnose
