#include "diagnose/draft/run_source.hpp"

#include <algorithm>
#include <iterator>

#include "diagnose/draft/files_of_a_run.hpp"
#include "diagnose/draft/runs_side_by_side.hpp"

namespace plumbline::diagnose {

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

std::vector<ColumnWords> RunSource::words(const std::vector<std::string>& joints) const {
  std::vector<ColumnWords> all;
  for (std::size_t c = 0; c < columns(); ++c) {
    const bool elsewhere = std::find(others.begin(), others.end(), c) != others.end();
    all.push_back(elsewhere ? ColumnWords{} : words_of(title(c), unit(c), joints));
    if (const auto kind = told.find(c); kind != told.end()) all.back().kind = kind->second;
  }
  return all;
}

std::vector<RunSource> run_sources(const std::vector<DraftFile>& files,
                                   const std::vector<std::string>& joints, Guesses& guesses) {
  std::vector<RunSource> all;
  for (RunSource& whole : files_of_runs(files, joints, guesses)) {
    std::vector<RunSource> runs = runs_side_by_side(whole, joints, guesses);
    std::move(runs.begin(), runs.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace plumbline::diagnose
