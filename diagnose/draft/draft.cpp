#include "diagnose/draft/draft.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/draft/draft_text.hpp"
#include "diagnose/screening/conventions.hpp"
#include "support/files/printable.hpp"

namespace plumbline::diagnose {
namespace {

/// What tells the runs in one table apart: a column that names them, or, where there is no time, commanded
/// angles that change.
std::vector<std::size_t> run_columns(const WrittenTable& table, const DraftModel& model) {
  std::vector<std::size_t> naming, commands;
  bool timed = false;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const ColumnWords words =
        words_of(table.names[c], c < table.units.size() ? table.units[c] : "", model.joints);
    const std::string& name = table.names[c];
    const bool numbered = !name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0;
    if (words.kind == Kind::run && !numbered) naming.push_back(c);  // "run 1" is a run, and names none
    if (words.kind == Kind::angle && words.commanded) commands.push_back(c);
    timed = timed || words.kind == Kind::time;
  }
  if (!naming.empty()) return naming;
  return timed ? std::vector<std::size_t>() : commands;
}

/// The table cut into one a run; itself where it has one.
std::vector<DraftFile> cut_into_runs(const DraftFile& file, const DraftModel& model, Guesses& guesses) {
  const WrittenTable table = written_table(file.text, file.name);
  if (table.format.transposed) return {file};
  const std::vector<std::size_t> columns = run_columns(table, model);
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

/// Readings enough to see what numbers mean.
void thin(Experiment& experiment) {
  constexpr std::size_t enough = 100;
  for (Run& run : experiment.runs) {
    const std::size_t step = run.readings.size() / enough + 1;
    std::vector<Reading> kept;
    for (std::size_t i = 0; i < run.readings.size(); i += step) kept.push_back(run.readings[i]);
    run.readings = std::move(kept);
  }
}

class Drafting {
 public:
  Drafting(std::string name, const DraftModel& model, const Ask& ask) : model_(model), ask_(ask) {
    experiment_.name = std::move(name);
  }

  void add(const std::vector<DraftFile>& files) {
    for (const DraftFile& file : files)
      for (DraftFile& one : cut_into_runs(file, model_, draft_.guesses)) {
        const auto same = [&](const DraftFile& other) { return other.name == one.name; };
        if (std::any_of(draft_.tables.begin(), draft_.tables.end(), same))
          throw Error(files::shown(one.name), "a table of this name already", "a name for each table");
        draft_.tables.push_back(std::move(one));
      }
    for (const RunSource& source : run_sources(draft_.tables, model_.joints, draft_.guesses)) {
      experiment_.runs.push_back(drafted_run(source, model_, ask_));
      const Guesses& guesses = experiment_.runs.back().guesses;
      draft_.guesses.insert(draft_.guesses.end(), guesses.begin(), guesses.end());
    }
    experiment_.loads = drafted_loads(experiment_.runs, model_, ask_, draft_.guesses);
  }

  Draft result() {
    // Each answer may bring the next question to light.
    constexpr int rounds = 6;
    for (int round = 0; round < rounds && settle(); ++round) continue;
    for (const DraftedRun& run : experiment_.runs)
      if (draft_.question.empty()) draft_.question = run.question;
    if (const std::string first = question_of_loads(); !first.empty())
      draft_.question = first + (draft_.question.empty() ? "" : "; ") + draft_.question;
    draft_.settings = settings_text(experiment_, model_);
    return std::move(draft_);
  }

 private:
  /// Asks what screening asks. \return whether a guess was changed by it
  bool settle() {
    draft_.question.clear();
    if (!question_of_loads().empty()) return false;  // nothing can be read before it is answered
    try {
      Experiment as_drafted = read();
      thin(as_drafted);
      const Study study(as_drafted);
      const std::optional<SuspectedConvention> suspected = suspected_convention(study);
      if (suspected && suspected->runs.empty() && take(*suspected)) return true;
      require_conventions(study);
    } catch (const Error& question) {
      draft_.question = question.what();
    }
    return false;
  }

  [[nodiscard]] std::string question_of_loads() const {
    return open_question(experiment_.loads, model_.chain.link_length.size());
  }

  [[nodiscard]] Experiment read() const {
    const std::string settings = settings_text(experiment_, model_);
    return read_experiment("", [&](const std::string& name, const std::string& place) {
      if (name == "experiment.toml") return settings;
      for (const DraftFile& table : draft_.tables)
        if (table.name == name) return table.text;
      throw Error(place, files::shown(name), "a table that was given");
    });
  }

  bool take(const SuspectedConvention& suspected) {
    const bool forces = suspected.what == "Fx, Fy", places = suspected.what == "x, y";
    bool taken = false;
    if (forces || places)
      taken =
          take_of_plane(suspected, forces ? draft_Fx : draft_x, forces ? quantity::force : quantity::length);
    if (suspected.what == "q") taken = take_of_angles(suspected);
    if (taken)
      draft_.guesses.push_back(
          {suspected.what, suspected.looks_like,
           suspected.start_error_as_read > 0
               ? fmt::format("the runs then start {:.2g} instead of {:.2g} lengths of the chain off",
                             suspected.start, suspected.start_error_as_read)
               : fmt::format("the misfit of the model then falls from {:.0f} % to {:.0f} %",
                             100 * suspected.misfit_as_read, 100 * suspected.left)});
    return taken;
  }

  /// A unit, a sign, or the axes swapped.
  bool take_of_plane(const SuspectedConvention& suspected, std::size_t first, const Quantity& quantity) {
    const auto says = [&](const char* words) {
      return suspected.looks_like.find(words) != std::string::npos;
    };
    const bool opposite = says("of the opposite sign"), swapped = says("swapped"),
               mirrored_x = says("with x mirrored"), mirrored_y = says("with y mirrored");
    std::string unit;
    if (!opposite && !swapped && !mirrored_x && !mirrored_y) {
      try {
        unit = parse_unit(suspected.looks_like, quantity, "").name;
      } catch (const Error&) {
        return false;  // turned axes, and what else needs a person
      }
    }
    for (DraftedRun& run : experiment_.runs) {
      auto &x = run.singles[first], &y = run.singles[first + 1];
      if (swapped) std::swap(x, y);
      for (auto* one : {&x, &y}) {
        if (!*one || (*one)->constant) continue;
        if (!unit.empty()) (*one)->unit = unit;
        if (opposite || (one == &x ? mirrored_x : mirrored_y)) (*one)->sign *= -1;
      }
    }
    return true;
  }

  bool take_of_angles(const SuspectedConvention& suspected) {
    if (suspected.looks_like == "absolute angles") experiment_.absolute_angles = true;
    for (DraftedRun& run : experiment_.runs)
      for (auto* angles : {&run.angles, &run.commands})
        for (DraftColumn& column : *angles) {
          if (suspected.looks_like == "degrees") column.unit = "deg";
          if (suspected.looks_like == "angles of the opposite sign") column.sign *= -1;
        }
    return suspected.looks_like != "angles in the reverse order";
  }

  const DraftModel& model_;
  const Ask& ask_;
  DraftedExperiment experiment_;
  Draft draft_;
};

}  // namespace

Draft draft_experiment(const std::string& name, const DraftModel& model, const std::vector<DraftFile>& files,
                       const Ask& ask) {
  if (files.empty()) throw Error("tables", "none", "one or more, a run each");
  Drafting drafting(name, model, ask);
  drafting.add(files);
  return drafting.result();
}

}  // namespace plumbline::diagnose
