#include "diagnose/draft/run_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <plumbline/base/error.hpp>
#include <tuple>

#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/files_of_a_run.hpp"
#include "diagnose/draft/runs_side_by_side.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

/// The quantity of a column, however it was treated.
auto quantity_in(const ColumnWords& words) {
  return std::tuple(words.kind, words.joint, words.commanded, words.at_motor, words.axis);
}

/// The better it is, the smaller: with a unit before without, as it was read before raw counts and filters.
auto rank(const ColumnWords& words) {
  return std::tuple(words.unit.empty(), words.treatment);
}

/// Of columns of one quantity, of which some say how they were treated, the others say nothing any more.
void take_one_treatment(std::vector<ColumnWords>& all) {
  for (ColumnWords& one : all) {
    if (one.kind == Kind::none || one.kind == Kind::doubled) continue;
    const auto is_same = [&](const ColumnWords& other) { return quantity_in(other) == quantity_in(one); };
    const bool treated = std::any_of(all.begin(), all.end(), [&](const ColumnWords& other) {
      return is_same(other) && other.treatment != Treatment::none;
    });
    const bool best = std::none_of(all.begin(), all.end(), [&](const ColumnWords& other) {
      return is_same(other) && rank(other) < rank(one);
    });
    if (treated && !best) one.kind = Kind::doubled;
  }
}

/// An encoder before the gear says what is commanded, unless a column of the command does.
void place_motors(std::vector<ColumnWords>& all) {
  const auto has = [&](bool commanded) {
    return std::any_of(all.begin(), all.end(), [&](const ColumnWords& one) {
      return one.kind == Kind::angle && !one.at_motor && one.commanded == commanded;
    });
  };
  const bool commanded = has(true), reached = has(false);
  for (ColumnWords& one : all) {
    if (!one.at_motor) continue;
    if (reached && !commanded) one.commanded = true;
    if (reached && commanded) one.kind = Kind::doubled;
  }
}

}  // namespace

std::string RunSource::name() const {
  return parts.size() > 1 || !others.empty() ? id : parts.front().file;
}

std::size_t RunSource::columns() const {
  return parts.back().first + parts.back().table.columns();
}

const SourcePart& RunSource::part_of(std::size_t column) const {
  if (follow) return parts.front();
  return *std::find_if(parts.rbegin(), parts.rend(),
                       [column](const SourcePart& one) { return one.first <= column; });
}

std::string RunSource::title(std::size_t column) const {
  const SourcePart& part = part_of(column);
  const std::vector<std::string>& names = part.table.names;
  return column - part.first < names.size() ? names[column - part.first] : "";
}

std::string RunSource::unit(std::size_t column) const {
  const SourcePart& part = part_of(column);
  const std::vector<std::string>& units = part.table.units;
  return column - part.first < units.size() ? units[column - part.first] : "";
}

std::vector<double> RunSource::numbers(std::size_t column) const {
  const SourcePart& part = part_of(column);
  std::vector<double> all = part.table.numbers(column - part.first);
  for (std::size_t p = 1; follow && p < parts.size(); ++p) {
    const std::vector<double> more = parts[p].table.numbers(column);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

std::string RunSource::shown_title(std::size_t column) const {
  const std::string name = title(column);
  return name.empty() ? fmt::format("column {}", column - part_of(column).first + 1) : name;
}

std::string RunSource::told_name(std::size_t column) const {
  const std::string name = title(column);
  return name.empty() ? fmt::format("{}", column - part_of(column).first + 1) : name;
}

std::vector<ColumnWords> RunSource::words(const std::vector<std::string>& joints) const {
  std::vector<ColumnWords> all;
  for (std::size_t c = 0; c < columns(); ++c) {
    const bool elsewhere = std::find(others.begin(), others.end(), c) != others.end();
    all.push_back(elsewhere ? ColumnWords{} : words_of(title(c), unit(c), joints));
    if (const auto said = told.find(c); said != told.end()) all.back() = said->second;
    if (all.back().kind != Kind::none && finite(numbers(c)).empty()) all.back() = {};
  }
  take_one_treatment(all);
  place_motors(all);
  return all;
}

std::set<std::string> take_told(RunSource& source, const std::vector<ToldColumn>& told) {
  std::set<std::string> known;
  for (const ToldColumn& one : told)
    for (std::size_t c = 0; c < source.columns(); ++c)
      if (source.told_name(c) == one.column ||
          fmt::format("{}", c - source.part_of(c).first + 1) == one.column)
        source.told[c] = one.words, known.insert(one.column);
  return known;
}

std::vector<RunSource> run_sources(const std::vector<DraftFile>& files,
                                   const std::vector<std::string>& joints,
                                   const std::vector<ToldColumn>& told, Guesses& guesses) {
  std::vector<RunSource> all;
  std::set<std::string> known;
  for (RunSource& whole : files_of_runs(files, joints, guesses)) {
    known.merge(take_told(whole, told));
    std::vector<RunSource> runs = runs_side_by_side(whole, joints, guesses);
    std::move(runs.begin(), runs.end(), std::back_inserter(all));
  }
  for (const ToldColumn& one : told)
    if (!known.contains(one.column))
      throw Error("--columns", files::shown(one.column), "the title of a column, or its number from 1");
  return all;
}

}  // namespace plumbline::diagnose
