#include "diagnose/draft/draft.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <plumbline/base/error.hpp>
#include <sstream>

#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/bench/read_parts.hpp"
#include "diagnose/draft/bench_choice.hpp"
#include "diagnose/draft/draft_text.hpp"
#include "diagnose/draft/drafted_arm.hpp"
#include "diagnose/draft/drafted_joint.hpp"
#include "diagnose/draft/given_tables.hpp"
#include "diagnose/draft/unused_columns.hpp"
#include "diagnose/screening/conventions.hpp"
#include "support/files/printable.hpp"
#include "support/files/toml_file.hpp"

namespace plumbline::diagnose {
namespace {

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

  void add(const std::vector<DraftFile>& files, const std::vector<ToldColumn>& told) {
    const std::vector<std::string>& joints = model_.names();
    draft_.tables = tables_of(files, joints, told, ask_, draft_.guesses);
    const std::vector<RunSource> sources = run_sources(draft_.tables, joints, told, draft_.guesses);
    draft_.bench = bench_of(model_, sources, joints);
    std::vector<UsedColumns> used = draft_.bench == BenchKind::arm ? add_arm(sources) : add_runs(sources);
    account_for_columns(used, joints, ask_, draft_.guesses);
  }

  Draft result() {
    if (draft_.bench == BenchKind::arm) {
      if (draft_.question.empty()) static_cast<void>(settle());
      return std::move(draft_);
    }
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
  std::vector<UsedColumns> add_arm(const std::vector<RunSource>& sources) {
    DraftedArm arm = drafted_arm(experiment_.name, sources, model_, ask_);
    std::vector<UsedColumns> used;
    for (std::size_t r = 0; r < sources.size(); ++r)
      used.push_back({sources[r], [columns = arm.used[r]](std::size_t c) {
                        return std::find(columns.begin(), columns.end(), c) != columns.end();
                      }});
    draft_.guesses.insert(draft_.guesses.end(), arm.guesses.begin(), arm.guesses.end());
    draft_.settings = std::move(arm.settings), draft_.tables = std::move(arm.tables);
    draft_.question = std::move(arm.question);
    return used;
  }

  std::vector<UsedColumns> add_runs(const std::vector<RunSource>& sources) {
    for (const RunSource& source : sources)
      experiment_.runs.push_back(draft_.bench == BenchKind::joint ? drafted_joint_run(source, model_, ask_)
                                                                  : drafted_run(source, model_, ask_));
    for (const DraftedRun& run : experiment_.runs)
      draft_.guesses.insert(draft_.guesses.end(), run.guesses.begin(), run.guesses.end());
    experiment_.loads = drafted_loads(experiment_.runs, model_, ask_, draft_.guesses);
    std::vector<UsedColumns> used;
    for (const DraftedRun& run : experiment_.runs)
      used.push_back({run.source, [&run](std::size_t c) { return run.uses(c); }});
    return used;
  }

  /// Asks what screening asks. \return whether a guess was changed by it
  bool settle() {
    draft_.question.clear();
    if (!question_of_loads().empty() || has_question())
      return false;  // nothing can be read before it is answered
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

  [[nodiscard]] bool has_question() const {
    return std::any_of(experiment_.runs.begin(), experiment_.runs.end(),
                       [](const DraftedRun& run) { return !run.end().has_links && !run.question.empty(); });
  }
  [[nodiscard]] std::string question_of_loads() const {
    return open_question(experiment_.loads, model_.chain.link_length.size());
  }

  [[nodiscard]] Experiment read() const {
    const std::string place = "experiment.toml", settings = draft_.bench == BenchKind::arm
                                                                ? draft_.settings
                                                                : settings_text(experiment_, model_);
    const ReadParts parts = [&](const Section& run, const SampleFormat& format) {
      return read_parts(run, format, [&](const std::string& name, const std::string& key) {
        for (const DraftFile& table : draft_.tables)
          if (table.name == name) return NamedText{name, table.text};
        throw Error(key, files::shown(name), "a table that was given");
      });
    };
    return read_experiment(
        files::parse_toml(settings, place), place, parts, nullptr,
        [&](const std::string&, const std::string&, const std::string&) { return *model_.arm; });
  }

  /// Whether the title of some of these columns says its unit, which a model cannot refute: then a person is
  /// asked. \param columns_of  a run
  [[nodiscard]] bool says_unit(const auto& columns_of) const {
    return std::any_of(experiment_.runs.begin(), experiment_.runs.end(), [&](const DraftedRun& run) {
      const std::vector<ColumnWords> words = run.source.words(model_.names());
      const std::vector<DraftColumn> columns = columns_of(run);
      return std::any_of(columns.begin(), columns.end(), [&](const DraftColumn& one) {
        return !one.constant && !words[one.place].unit.empty();
      });
    });
  }

  bool take(const SuspectedConvention& suspected) {
    const std::string& what = suspected.what;
    const bool forces = what == "Fx, Fy" || what == "Fx" || what == "torque",
               places = what == "x, y" || what == "x" || what == "angle";
    bool taken = false;
    if (forces || places) taken = take_of_end(suspected, forces ? draft_Fx : draft_x);
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
  bool take_of_end(const SuspectedConvention& suspected, std::size_t first) {
    const Quantity& quantity = *single_channels(model_.chain.device)[first].quantity;
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
    const auto of_end = [first](const DraftedRun& run) {
      std::vector<DraftColumn> columns;
      for (const std::size_t c : {first, first + 1})
        if (run.singles[c]) columns.push_back(*run.singles[c]);
      return columns;
    };
    if (!unit.empty() && says_unit(of_end)) return false;
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
    const auto of_joints = [](const DraftedRun& run) {
      std::vector<DraftColumn> columns = run.angles;
      columns.insert(columns.end(), run.commands.begin(), run.commands.end());
      return columns;
    };
    if (suspected.looks_like == "degrees" && says_unit(of_joints)) return false;
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
                       const Ask& ask, const std::vector<ToldColumn>& told) {
  if (files.empty()) throw Error("tables", "none", "one or more, a run each");
  Drafting drafting(name, model, ask);
  drafting.add(files, told);
  return drafting.result();
}

}  // namespace plumbline::diagnose
