#include "verify/paper/errata_file.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "verify/judging/characters.hpp"
#include "verify/judging/notation.hpp"
#include "verify/paper/toml_texts.hpp"

namespace plumbline::verify {
namespace {

/// "`F_x`" as "F_x": what a formula is, without its marks.
std::string unmarked(std::string text) {
  std::erase(text, '`');
  return text;
}

/// The paper's words for entries of a print, and the entries that take their place, as a reader sees them.
struct Replacement {
  std::string words, entry;
};

/// Entries that differ from each other in their numbers alone, and by one from each to the next: k1*q1,
/// k2*q2.
bool goes_on(const Printed& entries) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::string expected = entries.front();
    for (char& c : expected)
      if (is_digit(c)) c = static_cast<char>(c + static_cast<char>(i));
    if (expected != entries[i]) return false;
  }
  return entries.size() > 2 && entries.front() != entries[1];
}

/// "k1*q1" as "k_nq_n".
std::string last_of(const std::string& entry) {
  std::string text;
  for (const char c : entry) {
    if (c == '*') continue;
    text += is_digit(c) ? "_n" : std::string(1, c);
  }
  return text;
}

/// The entries of a print in brackets: one below the other, or so many rows of them.
std::string set_as(const std::string& form, const Printed& print, const std::string& place) {
  Printed entries;
  for (const std::string& entry : print) entries.push_back(formula_in_print(entry));
  if (form == "column") {
    if (goes_on(print)) entries = {entries[0], entries[1], "…", last_of(print[0])};
    return fmt::format("`[{}]ᵀ`", fmt::join(entries, ", "));
  }
  if (form == "list") return fmt::format("`{}`", fmt::join(entries, ", "));
  std::size_t rows = 0;
  if (form.ends_with(" rows") && is_digit(form.front())) rows = std::stoul(form);
  if (rows == 0 || entries.size() % rows != 0)
    throw Error(place, "as = '" + form + "'", "list, column, or a number of rows that the entries fill");
  const auto columns = static_cast<std::ptrdiff_t>(entries.size() / rows);
  std::vector<std::string> lines;
  for (auto row = entries.begin(); row != entries.end(); row += columns)
    lines.push_back(fmt::format("{}", fmt::join(row, row + columns, ", ")));
  return fmt::format("`[{}]`", fmt::join(lines, "; "));
}

/// What takes the place of what.
std::vector<Replacement> replacements(const toml::table& one, const Claim& claim, const Printed& print,
                                      const std::string& source) {
  const std::string place = files::place(one, source);
  const Printed words = texts(one, "for", source);
  if (one.contains("as")) {
    if (words.size() != 1) throw Error(place, fmt::format("{} texts `for`", words.size()), "one with `as`");
    return {{words.front(), set_as(text(one, "as", source), print, place)}};
  }
  std::vector<Replacement> list;
  for (std::size_t i = 0; i < print.size() && i < claim.printed.size(); ++i) {
    if (print[i] == claim.printed[i]) continue;
    const std::string entry = set_in_sentence(print[i], claim.words);
    const bool again = std::any_of(list.begin(), list.end(), [&](const Replacement& before) {
      return before.entry == entry && words.size() < list.size() + 1;
    });
    if (again) continue;  // the same entry again
    if (list.size() == words.size())
      throw Error(place, fmt::format("{} texts `for`", words.size()),
                  "one for each entry that becomes another");
    list.push_back({words[list.size()], entry});
  }
  if (list.size() != words.size() || print.size() != claim.printed.size())
    throw Error(place, fmt::format("{} texts `for` and {} entries", words.size(), print.size()),
                "one for each entry that becomes another, and as many entries as are printed");
  return list;
}

/// A text with one piece replaced. The piece stands in a formula where an odd number of marks is before it.
void replace(std::string& text, const Replacement& one, const std::string& place) {
  const std::size_t at = text.find(one.words);
  if (at == std::string::npos) throw Error(place, "“" + one.words + "” not in “" + text + "”", "words of it");
  const bool inside = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '`') % 2 != 0;
  text.replace(at, one.words.size(), inside ? unmarked(one.entry) : one.entry);
}

Correction correction(const toml::table& one, const Paper& paper, const std::string& source) {
  const std::string place = files::place(one, source);
  files::refuse_unknown_keys(one, {"claim", "print", "for", "within", "as"}, source);
  const Claim& claim = paper.claim(text(one, "claim", source));
  Correction read{claim.id, texts(one, "print", source), "", ""};
  const std::vector<Replacement> list = replacements(one, claim, read.print, source);
  if (list.empty()) throw Error(place, "nothing that becomes another", "a print that differs");
  read.printed = text(one, "within", source, list.front().words);
  if (claim.quote.find(unmarked(read.printed)) == std::string::npos)
    throw Error(place, "“" + read.printed + "”", "words of the quote of " + claim.id);
  read.read = read.printed;
  for (const Replacement& each : list) replace(read.read, each, place);
  // formulas that meet are one
  for (std::size_t at = read.read.find("``"); at != std::string::npos; at = read.read.find("``"))
    read.read.erase(at, 2);
  return read;
}

/// Two corrections of one sentence could contradict each other: a sentence is judged as one claim.
void refuse_parts_of_a_sentence(const Erratum& erratum, const Paper& paper, const std::string& place) {
  for (std::size_t i = 0; i < erratum.corrections.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Claim &a = paper.claim(erratum.corrections[i].claim),
                  &b = paper.claim(erratum.corrections[j].claim);
      if (a.where == b.where)
        throw Error(place, "two corrections at " + a.where + ", of " + b.id + " and " + a.id,
                    "one claim that judges the sentence as it reads with both");
    }
  }
}

}  // namespace

Erratum read_erratum(const toml::table& one, const Paper& paper, const std::string& source) {
  files::refuse_unknown_keys(one, {"id", "correction", "reason", "stands", "changes", "remark"}, source);
  Erratum erratum{text(one, "id", source),       {},
                  texts(one, "reason", source),  texts(one, "stands", source),
                  texts(one, "changes", source), one["remark"].value_or(false)};
  each(one, "correction", source,
       [&](const toml::table& table) { erratum.corrections.push_back(correction(table, paper, source)); });
  for (const auto* const ids : {&erratum.reason, &erratum.stands, &erratum.changes}) {
    for (const std::string& id : *ids) static_cast<void>(paper.claim(id));  // names one that there is not
  }
  refuse_parts_of_a_sentence(erratum, paper, files::place(one, source));
  return erratum;
}

}  // namespace plumbline::verify
