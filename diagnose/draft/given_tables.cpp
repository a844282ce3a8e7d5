#include "diagnose/draft/given_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "diagnose/draft/decoded.hpp"
#include "diagnose/draft/joined_clocks.hpp"
#include "diagnose/draft/json_lines.hpp"
#include "diagnose/draft/readable_table.hpp"
#include "diagnose/draft/workbook.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::diagnose {
namespace {

/// Columns that name the run of each line.
std::vector<std::size_t> run_columns(const WrittenTable& table, const std::vector<std::string>& joints,
                                     const std::vector<ToldColumn>& told) {
  std::vector<std::size_t> naming;
  for (std::size_t c = 0; c < table.columns(); ++c) {
    const std::string name = c < table.names.size() ? table.names[c] : "";
    const bool said = std::any_of(told.begin(), told.end(), [&](const ToldColumn& one) {
      return one.words.kind == Kind::run && (one.column == name || one.column == fmt::format("{}", c + 1));
    });
    const bool numbered = !name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0;
    const Kind kind = words_of(name, c < table.units.size() ? table.units[c] : "", joints).kind;
    if (said || (kind == Kind::run && !numbered)) naming.push_back(c);  // "run 1" is a run, and names none
  }
  return naming;
}

/// The table cut into one a run; itself where it has one.
std::vector<DraftFile> cut_into_runs(const DraftFile& file, const std::vector<std::string>& joints,
                                     const std::vector<ToldColumn>& told, Guesses& guesses) {
  const WrittenTable table = written_table(file.text, file.name);
  if (table.format.transposed) return {file};
  const std::vector<std::size_t> columns = run_columns(table, joints, told);
  std::vector<std::string> keys;
  std::map<std::string, std::vector<std::size_t>> lines;
  for (const files::CsvRow& row : table.table.rows) {
    std::string key;
    for (const std::size_t c : columns) key += (key.empty() ? "" : " ") + row.fields[c];
    if (!lines.contains(key)) keys.push_back(key);
    lines[key].push_back(row.line);
  }
  if (keys.size() < 2) return {file};
  constexpr std::size_t most = 1000;
  if (keys.size() > most)
    throw Error(file.name, fmt::format("{} runs", keys.size()), fmt::format("at most {}", most));
  std::vector<std::string> text;
  std::istringstream in(file.text);
  for (std::string line; std::getline(in, line);) text.push_back(line);
  std::string head;
  for (std::size_t l = 0; l + 1 < table.table.rows.front().line; ++l) head += text[l] + "\n";
  std::vector<DraftFile> runs;
  const std::size_t dot = std::min(file.name.find_last_of('.'), file.name.size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    DraftFile& run = runs.emplace_back(
        DraftFile{fmt::format("{}-{}{}", file.name.substr(0, dot), k + 1, file.name.substr(dot)), head});
    for (const std::size_t line : lines[keys[k]]) run.text += text[line - 1] + "\n";
  }
  std::vector<std::string> titles;
  for (const std::size_t c : columns) titles.push_back(table.names[c]);
  guesses.push_back(
      {"runs in " + file.name, fmt::format("{}", keys.size()),
       fmt::format("{} has so many values: each is a run, in a file of its own", fmt::join(titles, ", "))});
  return runs;
}

/// The sheet with the most numbers, or the one that a person names.
std::string sheet_of(const DraftFile& file, const Ask& ask, Guesses& guesses) {
  const std::vector<Sheet> sheets = sheets_of(file.text, file.name);
  const auto* most = &*std::max_element(sheets.begin(), sheets.end(),
                                        [](const Sheet& a, const Sheet& b) { return a.numbers < b.numbers; });
  std::vector<std::string> names;
  for (const Sheet& sheet : sheets) names.push_back(sheet.name);
  const bool several = sheets.size() > 1;
  Guess guess{
      "sheet of " + file.name, most->name,
      several ? fmt::format("it has the most numbers of {}", fmt::join(names, ", ")) : "the one with numbers",
      several, "the other sheets as files of their own, or --yes"};
  if (several && ask)
    if (const auto answer = ask(guess)) {
      const auto found = std::find(names.begin(), names.end(), *answer);
      if (found == names.end())
        throw Error(guess.what, files::shown(*answer), fmt::format("one of {}", fmt::join(names, ", ")));
      most = &sheets[static_cast<std::size_t>(found - names.begin())];
      guess = {guess.what, *answer, "as you said"};
    }
  guesses.push_back(std::move(guess));
  return most->text;
}

DraftFile text_in(const DraftFile& file, const Ask& ask, Guesses& guesses) {
  const std::size_t dot = file.name.find_last_of('.');
  if (is_workbook(file.text)) return {file.name.substr(0, dot) + ".csv", sheet_of(file, ask, guesses)};
  Decoded text = decoded(file.text);
  if (!text.encoding.empty())
    guesses.push_back({"encoding of " + file.name, text.encoding, "its bytes are no UTF-8"});
  if (!is_json_lines(text.text)) return {file.name, std::move(text.text)};
  guesses.push_back({"readings of " + file.name, "JSON", "each is an object; its keys are the columns"});
  return {file.name.substr(0, dot) + ".csv", csv_of_json_lines(text.text, file.name)};
}

}  // namespace

std::vector<DraftFile> tables_of(const std::vector<DraftFile>& files, const std::vector<std::string>& joints,
                                 const std::vector<ToldColumn>& told, const Ask& ask, Guesses& guesses) {
  std::vector<DraftFile> whole, all;
  for (const DraftFile& file : files) {
    DraftFile text = text_in(file, ask, guesses);
    files::require_text(text.text, text.name);
    whole.push_back({text.name, readable_table(text.text, text.name, guesses)});
  }
  for (const DraftFile& file : joined_clocks(std::move(whole), joints, guesses))
    for (DraftFile& one : cut_into_runs(file, joints, told, guesses)) {
      const auto same = [&](const DraftFile& other) { return other.name == one.name; };
      if (std::any_of(all.begin(), all.end(), same))
        throw Error(files::shown(one.name), "a table of this name already", "a name for each table");
      all.push_back(std::move(one));
    }
  return all;
}

}  // namespace plumbline::diagnose
