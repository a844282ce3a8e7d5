#include "diagnose/draft/seen_tables.hpp"

#include <algorithm>
#include <set>

#include "diagnose/draft/given_tables.hpp"
#include "diagnose/draft/told_columns.hpp"

namespace plumbline::diagnose {
namespace {

std::vector<std::string> first_fields(const WrittenTable& table, std::size_t column) {
  constexpr std::size_t most = 5;
  std::vector<std::string> first;
  for (const files::CsvRow& row : table.table.rows)
    if (first.size() < most) first.push_back(column < row.fields.size() ? row.fields[column] : "");
  return first;
}

SeenTable seen(const RunSource& source, const std::vector<std::string>& joints) {
  const WrittenTable& table = source.parts.front().table;
  const std::vector<ColumnWords> words = source.words(joints);
  SeenTable result{source.parts.front().file, {}};
  for (std::size_t c = 0; c < words.size(); ++c) {
    const std::string below = source.unit(c);
    result.columns.push_back({source.title(c) + (below.empty() ? "" : " [" + below + "]"),
                              source.told_name(c), channel_word(words[c]), words[c].unit, words[c].sign,
                              source.told.contains(c), first_fields(table, c)});
  }
  return result;
}

}  // namespace

std::vector<SeenTable> seen_tables(const std::vector<DraftFile>& files,
                                   const std::vector<std::string>& joints,
                                   const std::vector<ToldColumn>& told) {
  Guesses said_elsewhere;
  std::vector<SeenTable> all;
  std::set<std::vector<std::string>> known;
  for (const DraftFile& file : tables_of(files, joints, told, {}, said_elsewhere)) {
    RunSource source{file.name, {{file.name, written_table(file.text, file.name)}}};
    take_told(source, told);
    const std::vector<std::string>& names = source.parts.front().table.names;
    if (names.empty() || known.insert(names).second) all.push_back(seen(source, joints));
  }
  return all;
}

}  // namespace plumbline::diagnose
