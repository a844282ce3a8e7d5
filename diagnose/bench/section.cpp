#include "diagnose/bench/section.hpp"

#include <fmt/format.h>
#include <algorithm>

#include <cmath>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "support/files/nearest.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

double finite(const toml::node& node, const std::string& place, const std::string& expected) {
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

std::string Section::place(const std::string& key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr && !path_.empty()) node = table_;
  const auto number = node == nullptr ? 0 : node->source().begin.line;  // 0 of what no text holds
  const std::string line = number == 0 ? "" : ":" + std::to_string(number);
  return source_ + line + ": " + path_ + files::shown(key);
}

std::string Section::where() const {
  const auto number = table_->source().begin.line;  // 0 of what no text holds
  return number == 0 ? source_ : source_ + ":" + std::to_string(number);
}

std::vector<std::string> Section::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, value] : *table_) all.emplace_back(key.str());
  return all;
}

void Section::allow_only(const std::set<std::string>& keys, const std::set<std::string>& synonyms) const {
  for (const auto& [key, value] : *table_) {
    const std::string name(key.str());
    if (keys.contains(name) || synonyms.contains(name)) continue;
    throw Error(place(name), "an unknown key", files::expected_word(name, {keys.begin(), keys.end()}));
  }
}

const toml::node& Section::required(const std::string& key, const std::string& expected) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr) throw Error(place(key), "no such key", expected);
  return *node;
}

void Section::refuse(const std::string& key, const std::string& expected) const {
  throw Error(place(key), shown(required(key, expected)), expected);
}

Section Section::table(const std::string& key) const {
  const std::string expected = "a table [" + key + "]";
  if (!required(key, expected).is_table()) refuse(key, expected);
  return {*node(key).as_table(), source_, path_ + key + "."};
}

Section Section::table_or_empty(const std::string& key) const {
  static const toml::table empty;
  return has(key) ? table(key) : Section(empty, source_, path_ + key + ".");
}

std::vector<Section> Section::tables(const std::string& key) const {
  std::vector<Section> all;
  if (!has(key)) return all;
  if (!node(key).is_array() || !node(key).as_array()->is_homogeneous(toml::node_type::table))
    refuse(key, "tables [[" + key + "]]");
  for (const toml::node& entry : *node(key).as_array()) {
    const std::string number = "[" + std::to_string(all.size() + 1) + "].";
    all.push_back(Section(*entry.as_table(), source_, path_ + key + number));
  }
  return all;
}

std::string Section::text(const std::string& key, const std::string& expected) const {
  const toml::node& one = required(key, expected);
  if (!one.is_string() || one.as_string()->get().empty()) refuse(key, expected);
  files::require_printable(one.as_string()->get(), place(key));
  return one.as_string()->get();
}

std::string Section::one_of(const std::string& key, const std::vector<std::string>& words) const {
  std::string expected;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) expected += i + 1 < words.size() ? ", " : " or ";
    expected += "\"" + words[i] + "\"";
  }
  std::string word = text(key, expected);
  if (std::find(words.begin(), words.end(), word) == words.end()) refuse(key, expected);
  return word;
}

std::string Section::name(const std::string& key, const std::string& expected) const {
  const std::string one = text(key, expected);
  files::require_name(one, place(key));
  return one;
}

std::vector<std::string> Section::texts(const std::string& key, const std::string& expected) const {
  if (required(key, expected).is_string()) return {text(key, expected)};
  if (!node(key).is_array()) refuse(key, expected);
  std::vector<std::string> all;
  for (const toml::node& entry : *node(key).as_array()) {
    if (!entry.is_string()) refuse(key, expected);
    all.push_back(entry.as_string()->get());
  }
  return all;
}

bool Section::flag_or(const std::string& key, bool otherwise) const {
  if (!has(key)) return otherwise;
  if (!node(key).is_boolean()) refuse(key, "true or false");
  return node(key).as_boolean()->get();
}

double Section::number(const std::string& key, const std::string& expected) const {
  return finite(required(key, expected), place(key), expected);
}

double Section::non_negative(const std::string& key) const {
  if (!has(key)) return 0;
  const std::string expected = "a number, zero or positive";
  const double value = number(key, expected);
  if (value < 0) refuse(key, expected);
  return value;
}

std::size_t Section::whole_or(const std::string& key, std::size_t otherwise) const {
  if (!has(key)) return otherwise;
  if (!node(key).is_integer() || node(key).as_integer()->get() < 0)
    refuse(key, "a whole number, zero or positive");
  return static_cast<std::size_t>(node(key).as_integer()->get());
}

std::size_t Section::count(const std::string& key) const {
  if (!has(key)) return 0;
  if (!node(key).is_integer() || node(key).as_integer()->get() < 1) refuse(key, "an integer from 1");
  return static_cast<std::size_t>(node(key).as_integer()->get());
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
        finite(entry, place(key) + "[" + std::to_string(values.size() + 1) + "]", "a finite number"));
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
    values[own] = finite(value, place(key) + "." + files::shown(own), "a finite number");
  }
  return values;
}

}  // namespace plumbline::diagnose
