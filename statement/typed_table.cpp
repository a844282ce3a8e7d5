#include "statement/typed_table.hpp"

#include <algorithm>

#include "statement/decimal_toml.hpp"
#include "support/files/printable.hpp"

namespace plumbline::statement {

TypedTable::TypedTable(const toml::table& table, std::string source,
                       const std::vector<std::string_view>& known,
                       const std::vector<std::string_view>& synonyms)
    : table_(&table), source_(std::move(source)) {
  files::refuse_unknown_keys(table, known, source_, synonyms);
}

std::string TypedTable::place(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return (node != nullptr ? files::place(*node, source_) : source_) + ": " + std::string(key);
}

const toml::node& TypedTable::node(std::string_view key) const {
  const toml::node* node = table_->get(key);
  if (node == nullptr)
    throw Error(files::place(*table_, source_), "no key " + std::string(key), std::string(key) + " = …");
  return *node;
}

Rational TypedTable::number(std::string_view key) const {
  return number_of(node(key), place(key));
}

Rational TypedTable::positive(std::string_view key) const {
  const Rational value = number(key);
  if (value <= 0) throw Error(place(key), as_written(node(key)), "a positive number");
  return value;
}

Rational TypedTable::not_negative(std::string_view key) const {
  const Rational value = number(key);
  if (value < 0) throw Error(place(key), as_written(node(key)), "zero or a positive number");
  return value;
}

std::vector<Rational> TypedTable::numbers(std::string_view key) const {
  const toml::array* list = node(key).as_array();
  if (list == nullptr) throw Error(place(key), as_written(node(key)), "a list of numbers in brackets");
  return numbers_of(*list, place(key));
}

std::vector<Rational> TypedTable::numbers(std::string_view key, std::size_t count) const {
  std::vector<Rational> values = numbers(key);
  if (values.size() != count)
    throw Error(place(key), std::to_string(values.size()) + " values", std::to_string(count));
  return values;
}

std::string TypedTable::word(std::string_view key, const std::vector<std::string_view>& words) const {
  const std::string found = word_of(node(key));
  if (std::find(words.begin(), words.end(), found) != words.end()) return found;
  std::string expected;
  for (const std::string_view one : words)
    expected += (expected.empty() ? "\"" : ", \"") + std::string(one) + '"';
  throw Error(place(key), as_written(node(key)), expected);
}

bool TypedTable::flag(std::string_view key, bool otherwise) const {
  if (!has(key)) return otherwise;
  if (const auto value = node(key).value_exact<bool>()) return *value;
  const std::string found = as_written(node(key)), word = word_of(node(key));
  throw Error(place(key), word == found && !word.empty() ? '"' + found + '"' : found, "true or false");
}

TypedTable TypedTable::table(std::string_view key, const std::vector<std::string_view>& known) const {
  const toml::table* table = node(key).as_table();
  if (table == nullptr) throw Error(place(key), as_written(node(key)), "a table in braces");
  return {*table, source_, known};
}

std::vector<TypedTable> TypedTable::tables(std::string_view key, const std::vector<std::string_view>& known,
                                           const std::string& example) const {
  std::vector<TypedTable> all;
  if (!has(key)) return all;
  const toml::array* list = node(key).as_array();
  if (list == nullptr)
    throw Error(place(key), as_written(node(key)), "a list of tables, such as [" + example + "]");
  if (list->empty())
    throw Error(place(key), "an empty list", "one such as [" + example + "], or no such key");
  for (const toml::node& item : *list) {
    if (!item.is_table()) throw Error(place(key), as_written(item), "a table, such as " + example);
    all.emplace_back(*item.as_table(), source_, known);
  }
  return all;
}

std::string word_of(const toml::node& node) {
  if (decimals_in(node)) return "";
  return node.value_exact<std::string>().value_or(std::string());
}

}  // namespace plumbline::statement
