#include "verify/paper/toml_texts.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace plumbline::verify {

std::string text(const toml::table& table, const std::string& key, const std::string& source,
                 const std::optional<std::string>& otherwise) {
  if (const auto found = table[key].value<std::string>()) return *found;
  if (!otherwise || table.contains(key))
    throw Error(files::place(table, source), "no text '" + key + "'", "one");
  return *otherwise;
}

std::vector<std::string> texts(const toml::table& table, const std::string& key, const std::string& source) {
  if (!table.contains(key)) return {};
  const toml::array* const array = table[key].as_array();
  if (array == nullptr) return {text(table, key, source)};
  std::vector<std::string> list;
  for (const toml::node& node : *array) {
    const auto one = node.value<std::string>();
    if (!one) throw Error(files::place(node, source), "no text in '" + key + "'", "a list of texts");
    list.push_back(*one);
  }
  return list;
}

std::size_t choice(const toml::table& table, const std::string& key, const std::vector<std::string>& words,
                   const std::string& source) {
  const std::string word = text(table, key, source, words.front());
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw Error(files::place(table, source), fmt::format("{} = '{}'", key, word),
                fmt::format("{}", fmt::join(words, " or ")));
  return static_cast<std::size_t>(found - words.begin());
}

}  // namespace plumbline::verify
