#include "diagnose/draft/files_of_a_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "diagnose/draft/column_numbers.hpp"

namespace plumbline::diagnose {
namespace {

/// Steps between two readings that are no break.
constexpr double steps_apart = 2;

/// A file, looked at for the run that it is of.
struct Look {
  const RunSource& source;
  std::vector<ColumnWords> words;

  Look(const RunSource& of, const std::vector<std::string>& joints) : source(of), words(of.words(joints)) {}

  [[nodiscard]] bool has(bool (*is)(Kind)) const {
    return std::any_of(words.begin(), words.end(), [is](const ColumnWords& one) { return is(one.kind); });
  }
  [[nodiscard]] std::optional<std::size_t> time() const {
    const auto found = std::find_if(words.begin(), words.end(),
                                    [](const ColumnWords& one) { return one.kind == Kind::time; });
    if (found == words.end()) return {};
    return static_cast<std::size_t>(found - words.begin());
  }
};

/// Whether the values of a column go on in another within two of its largest steps.
bool goes_on(const std::vector<double>& before, const std::vector<double>& after) {
  double step = 0;
  for (std::size_t i = 1; i < before.size(); ++i) step = std::max(step, std::abs(before[i] - before[i - 1]));
  return std::abs(after.front() - before.back()) <= steps_apart * step;
}

/// Whether the second file is the rest of the first.
bool continues(const Look& first, const Look& second) {
  if (first.source.parts.front().table.names != second.source.parts.front().table.names || !first.time())
    return false;
  const std::vector<double> before = first.source.numbers(*first.time()),
                            after = second.source.numbers(*second.time());
  if (!(after.front() > before.back())) return false;
  for (std::size_t c = 0; c < first.words.size(); ++c) {
    const Kind kind = first.words[c].kind;
    const bool counts = c == *first.time() || is_force(kind) || is_place(kind) || is_actuation(kind);
    if (counts && !goes_on(first.source.numbers(c), second.source.numbers(c))) return false;
  }
  return true;
}

/// Whether one file has where the chain was, and the other what acts on it.
/// \param acts  forces, or tensions and pressures
bool are_apart(const Look& first, const Look& second, bool (*acts)(Kind)) {
  const auto only = [](const Look& one, bool (*is)(Kind), bool (*is_not)(Kind)) {
    return one.has(is) && !one.has(is_not);
  };
  return (only(first, acts, is_place) && only(second, is_place, acts)) ||
         (only(first, is_place, acts) && only(second, acts, is_place));
}

/// Whether one file has the forces and the other where the chain was, at the same times.
bool completes(const Look& first, const Look& second) {
  const bool apart = are_apart(first, second, is_force) || are_apart(first, second, is_actuation);
  return apart && first.time() && second.time() &&
         first.source.numbers(*first.time()) == second.source.numbers(*second.time());
}

}  // namespace

std::vector<RunSource> files_of_runs(const std::vector<DraftFile>& files,
                                     const std::vector<std::string>& joints, Guesses& guesses) {
  std::vector<RunSource> all;
  for (const DraftFile& file : files) {
    RunSource one{file.name.substr(0, file.name.find_last_of('.')),
                  {{file.name, written_table(file.text, file.name)}}};
    const Guesses& writing = one.parts.front().table.guesses;
    guesses.insert(guesses.end(), writing.begin(), writing.end());
    const Look second(one, joints);
    const auto of = std::find_if(all.begin(), all.end(), [&](const RunSource& other) {
      const Look first(other, joints);
      return (other.parts.size() == 1 && completes(first, second)) ||
             ((other.parts.size() == 1 || other.follow) && continues(first, second));
    });
    if (of == all.end()) {
      all.push_back(std::move(one));
      continue;
    }
    const bool follow = continues(Look(*of, joints), second);
    one.parts.front().first = follow ? 0 : of->columns();
    guesses.push_back({"files of " + of->id, fmt::format("{} and {}", of->parts.back().file, file.name),
                       follow ? "the second goes on where the first ends, in time and in every channel"
                              : "one has the forces, the other the places, at the same times"});
    of->parts.push_back(std::move(one.parts.front()));
    of->follow = follow;
  }
  return all;
}

}  // namespace plumbline::diagnose
