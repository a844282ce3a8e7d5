#include "verify/paper/errata_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <plumbline/base/error.hpp>
#include <set>

#include "verify/judging/characters.hpp"
#include "verify/judging/notation.hpp"
#include "verify/paper/toml_texts.hpp"

namespace plumbline::verify {
namespace {

using Words = std::map<std::string, std::string>;  ///< by the entry of a print that they say

/// "`F_x`" as "F_x": what a formula is, without its marks.
std::string unmarked(std::string text) {
  std::erase(text, '`');
  return text;
}

/// An entry of a print as a reader sees it.
std::string said(const std::string& entry, const Words& words) {
  const auto found = words.find(entry);
  return found != words.end() ? found->second : "`" + formula_in_print(entry) + "`";
}

/// The paper's words with those of each entry that becomes another in their place.
std::string replaced(std::string text, const Printed& from, const Printed& to, const Words& words,
                     const std::string& place) {
  for (std::size_t i = 0; i < from.size() && i < to.size(); ++i) {
    if (from[i] == to[i]) continue;
    const std::string old = said(from[i], words);
    const std::size_t at = text.find(old);
    if (at == std::string::npos)
      throw Error(place, "“" + old + "” not in “" + text + "”",
                  "the words of the entry that is wrong, or `read`");
    text.replace(at, old.size(), said(to[i], words));
  }
  return text;
}

/// An entry with its numbers left out: what a sequence such as k_1 q_1, k_2 q_2, … goes on with.
std::string without_numbers(std::string entry) {
  std::erase_if(entry, is_digit);
  return entry;
}

/// `read` with the entries of the print in place of {1}, {2} and so on; an ellipsis stands for further ones
/// that differ from them in their numbers alone.
std::string filled(std::string text, const Printed& from, const Printed& to, const Words& words,
                   const std::string& place) {
  std::set<std::string> used;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const std::string mark = fmt::format("{{{}}}", i + 1);
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) {
      text.replace(at, mark.size(), said(to[i], words));
      used.insert(to[i]);
    }
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    const bool same = from.size() == to.size() && from[i] == to[i];
    const bool goes_on = text.find("…") != std::string::npos &&
                         std::any_of(used.begin(), used.end(), [&](const std::string& one) {
                           return without_numbers(one) == without_numbers(to[i]);
                         });
    if (!same && !used.contains(to[i]) && !goes_on)
      throw Error(place, fmt::format("no {{{}}} in “{}”", i + 1, text), "each entry that becomes another");
  }
  return text;
}

Correction correction(const toml::table& one, const Paper& paper, const std::string& source) {
  const std::string place = files::place(one, source);
  files::refuse_unknown_keys(one, {"claim", "print", "for", "read", "words"}, source);
  const Claim& claim = paper.claim(text(one, "claim", source));
  Words words;
  if (const toml::table* const table = one["words"].as_table())
    for (const auto& [key, node] : *table) words[std::string(key.str())] = node.value_or(std::string());
  Correction read{claim.id, texts(one, "print", source), text(one, "for", source, claim.quote), ""};
  if (claim.quote.find(unmarked(read.printed)) == std::string::npos)
    throw Error(place, "“" + read.printed + "”", "words of the quote of " + claim.id);
  for (const std::string& entry : read.print.size() == claim.printed.size() ? claim.printed : Printed{}) {
    const auto its = words.find(entry);
    if (its != words.end() && claim.quote.find(unmarked(its->second)) == std::string::npos)
      throw Error(place, "“" + its->second + "” for “" + entry + "”", "words of the quote of " + claim.id);
  }
  read.read = one.contains("read")
                  ? filled(text(one, "read", source), claim.printed, read.print, words, place)
                  : replaced(read.printed, claim.printed, read.print, words, place);
  // formulas that meet are one
  for (std::size_t at = read.read.find("``"); at != std::string::npos; at = read.read.find("``"))
    read.read.erase(at, 2);
  return read;
}

Sentence sentence(const toml::node& node, const std::string& source) {
  const toml::array* const list = node.as_array();
  std::vector<std::string> entries;
  if (list != nullptr)
    for (const toml::node& entry : *list) entries.push_back(entry.value_or(std::string()));
  if (entries.size() < 2)
    throw Error(files::place(node, source), "a sentence that nothing holds", "[\"text\", \"id\", …]");
  return {entries.front(), {entries.begin() + 1, entries.end()}};
}

/// Pairs of what a reader calls it and the id.
std::vector<Named> names(const toml::table& one, const std::string& key, const std::string& source) {
  std::vector<Named> list;
  const toml::array* const pairs = one[key].as_array();
  if (pairs == nullptr) return list;
  for (const toml::node& node : *pairs) {
    const toml::array* const pair = node.as_array();
    if (pair == nullptr || pair->size() != 2)
      throw Error(files::place(node, source), "no pair in " + key, "[\"name\", \"id\"]");
    list.push_back({(*pair)[1].value_or(std::string()), (*pair)[0].value_or(std::string())});
  }
  return list;
}

}  // namespace

Erratum read_erratum(const toml::table& one, const Paper& paper, const std::string& source) {
  files::refuse_unknown_keys(one, {"id", "title", "correction", "reason", "stands", "changes", "remark"},
                             source);
  Erratum erratum{
      text(one, "id", source),       text(one, "title", source),   {}, {}, names(one, "stands", source),
      names(one, "changes", source), one["remark"].value_or(false)};
  each(one, "correction", source,
       [&](const toml::table& table) { erratum.corrections.push_back(correction(table, paper, source)); });
  if (const toml::array* const reason = one["reason"].as_array())
    for (const toml::node& node : *reason) erratum.reason.push_back(sentence(node, source));
  return erratum;
}

}  // namespace plumbline::verify
