#include "verify/paper/paper.hpp"

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "support/files/toml_file.hpp"
#include "verify/judging/notation.hpp"
#include "verify/paper/texts.hpp"

namespace plumbline::verify {
namespace {

std::string text(const toml::table& table, const std::string& key, const std::string& source,
                 const std::optional<std::string>& otherwise = std::nullopt) {
  if (const auto found = table[key].value<std::string>()) return *found;
  if (!otherwise || table.contains(key))
    throw Error(files::place(table, source), "no text '" + key + "'", "one");
  return *otherwise;
}

std::vector<std::string> texts(const toml::table& table, const std::string& key, const std::string& source) {
  std::vector<std::string> list;
  const toml::array* const array = table[key].as_array();
  if (array == nullptr) return list;
  for (const toml::node& node : *array) {
    const auto one = node.value<std::string>();
    if (!one) throw Error(files::place(node, source), "no text in '" + key + "'", "a list of texts");
    list.push_back(*one);
  }
  return list;
}

/// One of several words, as the number of its place.
std::size_t choice(const toml::table& table, const std::string& key, const std::vector<std::string>& words,
                   const std::string& source) {
  const std::string word = text(table, key, source, words.front());
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) throw Error(files::place(table, source), key + " = '" + word + "'", words.back());
  return static_cast<std::size_t>(found - words.begin());
}

template <class Read>
void each(const toml::table& file, const std::string& name, const std::string& source, const Read& read) {
  const toml::array* const list = file[name].as_array();
  if (list == nullptr) throw Error(source, "no [[" + name + "]]", "at least one");
  for (const toml::node& node : *list) read(*node.as_table());
}

void add_section(Paper& paper, const std::string& source, const char* content) {
  const toml::table file = files::parse_toml(content, source);
  files::refuse_unknown_keys(file, {"section", "title", "claim"}, source);
  const std::string section = text(file, "section", source);
  if (paper.sections.empty() || paper.sections.back().number != section)
    paper.sections.push_back({section, text(file, "title", source)});
  if (!file.contains("claim")) return;  // it says again what others say
  each(file, "claim", source, [&](const toml::table& one) {
    files::refuse_unknown_keys(one,
                               {"id", "where", "also", "quote", "reading", "printed", "words", "list",
                                "charity", "subject", "cause"},
                               source);
    const std::string id = text(one, "id", source);
    paper.claims.push_back(
        {id,
         section + ", " + text(one, "where", source),
         texts(one, "also", source),
         text(one, "quote", source),
         in_notation(text(one, "reading", source)),
         choice(one, "charity", {"literal", "charitable"}, source) == 1,
         texts(one, "printed", source),
         texts(one, "words", source),
         one["list"].value_or(false),
         static_cast<Subject>(choice(one, "subject", {"statement", "number", "name"}, source)),
         text(one, "cause", source, id),
         {},
         {}});
  });
}

void add_causes(Paper& paper, const std::string& source, const char* content) {
  each(files::parse_toml(content, source), "cause", source, [&](const toml::table& one) {
    files::refuse_unknown_keys(one, {"id", "title", "correction", "effect", "unchanged"}, source);
    paper.causes.push_back({text(one, "id", source), text(one, "title", source),
                            text(one, "correction", source), text(one, "effect", source),
                            texts(one, "unchanged", source)});
  });
}

}  // namespace

const Paper& paper() {
  static const Paper instance = [] {
    Paper read;
    for (const auto& [name, content] : section_texts) add_section(read, name, content);
    add_causes(read, "causes.toml", causes_text);
    return read;
  }();
  return instance;
}

const Printed& printed_in_paper(const std::string& id) {
  for (const Claim& claim : paper().claims) {
    if (claim.id == id) return claim.printed;
  }
  throw Error("claim " + id, "no passage", "one in the paper");
}

std::string section_title(const std::string& number) {
  for (const PaperSection& section : paper().sections) {
    if (section.number == number) return section.title;
  }
  return "";
}

}  // namespace plumbline::verify
