#include "app/diagnose_change.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <plumbline/base/error.hpp>

#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "diagnose/bench/states.hpp"
#include "diagnose/change/change_report.hpp"
#include "diagnose/change/motion_change_report.hpp"
#include "diagnose/motion/read_bench.hpp"
#include "diagnose/report/report.hpp"

namespace plumbline::app {
namespace {

struct ComparedStates {
  diagnose::StudyFiles before, after;

  [[nodiscard]] std::vector<std::filesystem::path> files() const {
    std::vector<std::filesystem::path> all = after.all();
    if (before.folder != after.folder)
      for (const std::filesystem::path& file : before.all()) all.push_back(file);
    return all;
  }
};

/// Two folders, or two states of one.
ComparedStates states_of(const ChangeOptions& options) {
  ComparedStates states{options.after, options.after};
  if (std::filesystem::exists(options.before)) {
    states.before.folder = options.before;
    return states;
  }
  const std::vector<std::string> known = diagnose::states_in(options.after.folder);
  if (known.empty()) throw Error("--against", options.before, "a folder, or a state that [[run]] names");
  if (known.size() != 2)
    throw Error("--against", fmt::format("{} states in {}", known.size(), options.after.folder.string()),
                "two; --since compares more");
  states.before.state = options.before;
  states.after.state = known.front() == options.before ? known.back() : known.front();
  return states;
}

void end_with(diagnose::Check check, bool is_asked) {
  if (const int status = static_cast<int>(check); is_asked && status != 0) throw CLI::RuntimeError(status);
}

}  // namespace

void diagnose_change(const ChangeOptions& options, const CLI::App& verb) {
  const auto [before, after] = states_of(options);
  const diagnose::Experiment first = experiment_of(before), second = experiment_of(after);
  Outputs outputs(verb, ComparedStates{before, after}.files());
  files::OutputFile *const json = outputs.open("--json", options.json), *const html = outputs.open(
                                                                            "--html", options.html);
  const diagnose::Change change = with_progress("change", [&](const auto& show) {
    return diagnose::what_changed(study_of(first, before.effects), study_of(second, after.effects), show);
  });
  const page::Provenance& from = outputs.provenance();
  if (json) json->write(page::json_text(as_json(change), from));
  if (html) html->write(page::on_page(diagnose::as_html(change.study, change.diagnosis), from));
  outputs.commit();
  if (options.json != "-" && options.html != "-") fmt::print("{}", as_text(change));
  end_with(check(change), options.check);
}

void diagnose_motion_change(const ChangeOptions& options, const CLI::App& verb) {
  const std::filesystem::path before = options.before, after = options.after.folder;
  Outputs outputs(verb, {after / "experiment.toml", before / "experiment.toml"});
  files::OutputFile* const json = outputs.open("--json", options.json);
  const motion::Bench first = motion::read_bench(before), second = motion::read_bench(after);
  const diagnose::MotionChange change =
      with_progress("change", [&](const auto& show) { return diagnose::what_changed(first, second, show); });
  if (json) json->write(page::json_text(as_json(change), outputs.provenance()));
  outputs.commit();
  if (options.json != "-") fmt::print("{}", as_text(change));
  end_with(check(change), options.check);
}

}  // namespace plumbline::app
