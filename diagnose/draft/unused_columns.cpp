#include "diagnose/draft/unused_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "diagnose/draft/column_numbers.hpp"
#include "diagnose/draft/told_columns.hpp"

namespace plumbline::diagnose {
namespace {

std::string reason_of(const RunSource& source, std::size_t column, const ColumnWords& words,
                      const std::vector<std::string>& joints) {
  const ColumnWords own = words_of(source.title(column), source.unit(column), joints);
  if (words.kind == Kind::left_out) return "as you said";
  if (finite(source.numbers(column)).empty()) return "no numbers stand there";
  if (words.kind == Kind::doubled)
    return own.treatment == Treatment::raw        ? "another column has it in its unit"
           : own.treatment == Treatment::filtered ? "another column has it unfiltered"
           : own.at_motor                         ? "the motor's side of joints whose command is there"
                                                  : "another column has it";
  if (words.kind == Kind::none) return "its name says no quantity of this bench";
  return fmt::format("{}, and this bench has no channel for it", name_of(words.kind));
}

}  // namespace

void account_for_columns(const std::vector<UsedColumns>& runs, const std::vector<std::string>& joints,
                         const Ask& ask, Guesses& guesses) {
  std::set<std::string> said;
  for (const UsedColumns& run : runs) {
    const RunSource& source = run.source;
    const std::vector<ColumnWords> words = source.words(joints);
    for (std::size_t c = 0; c < words.size(); ++c) {
      const bool elsewhere = std::find(source.others.begin(), source.others.end(), c) != source.others.end();
      const std::string title = source.shown_title(c);
      const bool empty = source.title(c).empty() && finite(source.numbers(c)).empty();
      const bool once = words[c].kind == Kind::time || words[c].kind == Kind::run;  // of the parts of a run
      if (elsewhere || empty || run.uses(c) || !said.insert(source.part_of(c).file + "\n" + title).second)
        continue;
      Guess guess{"column " + title, "not used", reason_of(source, c, words[c], joints), is_missed(words[c]),
                  columns_option({{source.told_name(c), {.kind = Kind::left_out}}})};
      if (once)
        guess.reason = words[c].kind == Kind::time ? "the time of another file counts" : "it names the runs";
      if (guess.doubtful && ask && ask(guess)) guess.doubtful = false;
      guesses.push_back(std::move(guess));
    }
  }
}

}  // namespace plumbline::diagnose
