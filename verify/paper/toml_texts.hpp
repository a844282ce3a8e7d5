#pragma once
/// \file
/// Texts and lists of texts in the files of a paper.

#include <optional>
#include <plumbline/base/error.hpp>
#include <string>
#include <vector>

#include "support/files/toml_file.hpp"

namespace plumbline::verify {

/// The text of a key. \throws Error that names the place where there is none and no other is given
std::string text(const toml::table& table, const std::string& key, const std::string& source,
                 const std::optional<std::string>& otherwise = std::nullopt);

/// The list of texts of a key, or its one text; empty where there is no such key.
std::vector<std::string> texts(const toml::table& table, const std::string& key, const std::string& source);

/// One of several words, as the number of its place; the first where there is none.
std::size_t choice(const toml::table& table, const std::string& key, const std::vector<std::string>& words,
                   const std::string& source);

/// Calls `read` with each table of a list of tables; with none where there is no such list.
template <class Read>
void each(const toml::table& file, const std::string& name, const std::string& source, const Read& read) {
  const auto node = file[name];
  if (!node) return;
  const toml::array* const list = node.as_array();
  if (list == nullptr) throw Error(source, "no list of tables [[" + name + "]]", "one");
  for (const toml::node& one : *list) {
    if (!one.is_table()) throw Error(files::place(one, source), "no table in " + name, "[[" + name + "]]");
    read(*one.as_table());
  }
}

}  // namespace plumbline::verify
