#include "diagnose/draft/runs_side_by_side.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>

#include "diagnose/draft/told_columns.hpp"

namespace plumbline::diagnose {
namespace {

/// By run, its own columns.
using Blocks = std::vector<std::vector<std::size_t>>;

bool any(const std::vector<ColumnWords>& words, bool (*is)(Kind)) {
  return std::any_of(words.begin(), words.end(), [is](const ColumnWords& one) { return is(one.kind); });
}

/// Columns of one meaning, in their order.
std::vector<std::vector<std::size_t>> alike(const std::vector<ColumnWords>& words) {
  std::map<std::tuple<Kind, std::size_t, bool, bool>, std::vector<std::size_t>> by_meaning;
  for (std::size_t c = 0; c < words.size(); ++c) {
    const bool unnumbered =
        words[c].kind == Kind::angle && words[c].joint == 0;  // in the order of the joints
    const bool counts = words[c].kind == Kind::time || is_force(words[c].kind) || is_place(words[c].kind);
    if (!counts || unnumbered) continue;
    by_meaning[{words[c].kind, words[c].joint, words[c].commanded, words[c].at_motor}].push_back(c);
  }
  std::vector<std::vector<std::size_t>> all;
  for (auto& [meaning, columns] : by_meaning) all.push_back(std::move(columns));
  return all;
}

/// Tensions and pressures that stand in every block, in their order; others are common to all runs.
void share_actuators(const std::vector<ColumnWords>& words, Blocks& blocks) {
  for (const Kind kind : {Kind::tension, Kind::pressure}) {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < words.size(); ++c)
      if (words[c].kind == kind) columns.push_back(c);
    if (columns.size() % blocks.size() != 0) continue;
    const std::size_t each = columns.size() / blocks.size();
    for (std::size_t i = 0; i < columns.size(); ++i) blocks[i / each].push_back(columns[i]);
  }
}

/// Blocks that repeat: every force, place and angle once, or as often as there are blocks; likewise the time.
Blocks repeated(const std::vector<ColumnWords>& words) {
  std::size_t most = 1;
  const auto groups = alike(words);
  const auto is_time = [&](const std::vector<std::size_t>& columns) {
    return words[columns.front()].kind == Kind::time;
  };
  for (const auto& columns : groups)
    if (!is_time(columns)) most = std::max(most, columns.size());
  Blocks blocks(most);
  for (const auto& columns : groups) {
    if (columns.size() == 1) continue;
    if (columns.size() != most) return {};
    for (std::size_t run = 0; run < most; ++run) blocks[run].push_back(columns[run]);
  }
  if (most == 1) return {};
  share_actuators(words, blocks);
  return blocks;
}

/// A title in small letters without its number.
std::string stem(std::string title) {
  while (!title.empty() && std::isalpha(static_cast<unsigned char>(title.back())) == 0) title.pop_back();
  for (char& c : title) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return title;
}

/// The most columns of one name and different numbers whose content no word says.
Blocks numbered(const RunSource& whole, const std::vector<ColumnWords>& words) {
  std::map<std::string, Blocks> by_stem;
  for (std::size_t c = 0; c < words.size(); ++c) {
    const std::string title = whole.title(c), name = stem(title);
    const bool unsaid =
        words[c].kind == Kind::none || words[c].kind == Kind::run || words[c].kind == Kind::number;
    if (unsaid && !name.empty() && name.size() < title.size()) by_stem[name].push_back({c});
  }
  Blocks best;
  for (const auto& [name, blocks] : by_stem)
    if (blocks.size() > 1 && blocks.size() > best.size()) best = blocks;
  return best;
}

/// The content of numbered columns beside one imposed quantity of the end point: the other one, along the
/// same axis. Beside angles they are of the joints, and no word says how.
Kind answer_of(const std::vector<ColumnWords>& words) {
  const bool forces = any(words, is_force), places = any(words, is_place);
  if (forces == places || any(words, [](Kind kind) { return kind == Kind::angle; })) return Kind::none;
  if (forces) return any(words, [](Kind kind) { return kind == Kind::force_y; }) ? Kind::y : Kind::x;
  return any(words, [](Kind kind) { return kind == Kind::y; }) ? Kind::force_y : Kind::force_x;
}

std::vector<RunSource> apart(const RunSource& whole, const Blocks& blocks, Kind told) {
  std::vector<RunSource> runs(blocks.size(), whole);
  for (std::size_t run = 0; run < runs.size(); ++run) {
    runs[run].id = told == Kind::none ? fmt::format("{}-{}", whole.id, run + 1)
                                      : fmt::format("{}-{}", whole.id, whole.title(blocks[run].front()));
    for (std::size_t other = 0; other < blocks.size(); ++other)
      if (other != run)
        runs[run].others.insert(runs[run].others.end(), blocks[other].begin(), blocks[other].end());
    if (told != Kind::none) runs[run].told[blocks[run].front()] = ColumnWords{told};
  }
  return runs;
}

/// The line that a script writes: what the columns of each run hold.
std::string told_line(const RunSource& whole, const Blocks& blocks, const ColumnWords& words) {
  std::vector<ToldColumn> told;
  for (const auto& block : blocks) told.push_back({whole.told_name(block.front()), words});
  return columns_option(told);
}

std::string titles(const RunSource& whole, const Blocks& blocks) {
  std::vector<std::string> all;
  for (const std::size_t c : blocks[0]) all.push_back(whole.title(c));
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace

std::vector<RunSource> runs_side_by_side(const RunSource& whole, const std::vector<std::string>& joints,
                                         Guesses& guesses) {
  if (whole.parts.size() > 1) return {whole};
  const std::vector<ColumnWords> words = whole.words(joints);
  const std::string what = "runs in " + whole.parts.front().file;
  if (const Blocks blocks = repeated(words); !blocks.empty()) {
    const bool told = whole.told.contains(blocks[0].front());
    guesses.push_back({what, fmt::format("{} side by side", blocks.size()),
                       fmt::format("columns like {} stand there so many times", titles(whole, blocks)),
                       blocks[0].size() == 1 && !told, told_line(whole, blocks, words[blocks[0].front()])});
    return apart(whole, blocks, Kind::none);
  }
  const Kind answer = answer_of(words);
  const Blocks blocks = numbered(whole, words);
  if (answer == Kind::none || blocks.empty()) return {whole};
  guesses.push_back({what, fmt::format("{} side by side", blocks.size()),
                     fmt::format("columns like {} are numbered: taken for the {} of a run each",
                                 titles(whole, blocks), is_force(answer) ? "force" : "place"),
                     true, told_line(whole, blocks, ColumnWords{answer})});
  return apart(whole, blocks, answer);
}

}  // namespace plumbline::diagnose
