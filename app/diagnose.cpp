#include <fmt/core.h>

#include <memory>
#include <plumbline/base/error.hpp>
#include <vector>

#include "app/arguments.hpp"
#include "app/corrected_files.hpp"
#include "app/diagnose_change.hpp"
#include "app/diagnose_many.hpp"
#include "app/diagnose_motion.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "diagnose/api/report.hpp"
#include "diagnose/api/study_files.hpp"
#include "diagnose/change/change_plan.hpp"
#include "diagnose/report/plan.hpp"
#include "support/files/experiment_files.hpp"

namespace plumbline::app {
namespace {

struct DiagnoseOptions {
  std::vector<std::string> experiments;
  std::string effects, model, corrected, json, html, reports, against, change;
  bool next = false, as_is = false, plan = false, check = false, since = false;

  [[nodiscard]] diagnose::StudyFiles input() const {
    return {experiments.empty() ? "" : experiments.front(), model, effects};
  }
};

void run_plan(const DiagnoseOptions& options, const CLI::App& verb) {
  if (options.experiments.size() > 1) throw Error("--plan", "several experiments", "one bench");
  const diagnose::StudyFiles input = options.input();
  const diagnose::Experiment read = bench_of(input);
  Outputs outputs(verb, input.all());
  files::OutputFile* const json = outputs.open("--json", options.json);
  const diagnose::Experiment bench = study_of(read, input.effects).experiment();
  if (!options.change.empty()) {
    const diagnose::ChangePlan plan = diagnose::plan_of_change(bench, options.change);
    if (json) json->write(page::json_text(as_json(plan), outputs.provenance()));
    outputs.commit();
    if (options.json != "-") fmt::print("{}", as_text(plan));
    return;
  }
  const diagnose::Plan plan =
      with_progress("plan", [&](const auto& show) { return diagnose::plan(bench, show); });
  if (json) json->write(page::json_text(as_json(plan), outputs.provenance()));
  outputs.commit();
  if (options.json != "-") fmt::print("{}", as_text(plan));
}

void run_many(const DiagnoseOptions& options, const CLI::App& verb) {
  if (!options.corrected.empty())
    throw Error("--corrected", "several experiments, or --reports",
                "one experiment, whose model is corrected");
  ManyExperiments many{
      options.experiments, options.reports, options.json, options.html, {}, {options.model, options.effects}};
  if (!options.model.empty()) many.words.insert(many.words.end(), {"--model", options.model});
  if (!options.effects.empty()) many.words.insert(many.words.end(), {"--effects", options.effects});
  if (!options.against.empty()) {
    many.words.insert(many.words.end(), {"--against", options.against});
    for (const auto& file : files::files_read(options.against)) many.inputs.push_back(file.string());
  }
  if (options.next) many.words.emplace_back("--next");
  if (options.as_is) many.words.emplace_back("--as-is");
  diagnose_many(many, verb);
}

/// The reason why --next has no proposal.
const char* nothing_next(const diagnose::Diagnosis& diagnosis) {
  if (!diagnosis.gap.present)
    return "What next?  No gap to explain; --plan says which effects the bench can show\n";
  if (diagnosis.cause.ranking.size() < 2) return "What next?  Only one explanation is left\n";
  return "What next?  No feasible run distinguishes the explanations\n";
}

void run_diagnosis(const DiagnoseOptions& options, const CLI::App& verb) {
  const diagnose::StudyFiles input = options.input();
  const diagnose::Experiment experiment = experiment_of(input);
  Outputs outputs(verb, input.all());
  files::OutputFile *const json = outputs.open("--json", options.json), *const html = outputs.open(
                                                                            "--html", options.html);
  CorrectedFiles corrected(outputs, options.corrected);
  const diagnose::Report report = with_progress("diagnosis", [&](const auto& show) {
    return diagnose::Report(study_of(experiment, input.effects), {options.as_is, options.next, show});
  });
  if (corrected.wanted()) corrected.write(report.corrected(input.nominal_model()));
  nlohmann::ordered_json all = report.json();
  if (corrected.wanted()) all["corrected"] = corrected.as_json();
  const page::Provenance& from = outputs.provenance();
  if (json) json->write(page::json_text(std::move(all), from));
  if (html) html->write(page::on_page(report.html(), from));
  outputs.commit();
  if (options.json == "-" || options.html == "-") return;
  fmt::print("{}{}", report.text(), corrected.as_text());
  if (options.next && report.diagnosis().proposals.empty())
    fmt::print("\n{}", nothing_next(report.diagnosis()));
}

/// Options that an experiment of motion does not take, and whatever of `others` it does not take either.
void refuse_for_motion(const DiagnoseOptions& options,
                       std::vector<std::pair<const char*, std::string>> others) {
  others.insert(others.end(), {{"--model", options.model}, {"--effects", options.effects}});
  for (const auto& [name, value] : others)
    if (!value.empty()) throw Error(name, "an experiment of motion", "a bench of loads or poses");
  if (options.since) throw Error("--since", "an experiment of motion", "a bench of loads or poses");
}

void run_motion(const DiagnoseOptions& options, const CLI::App& verb) {
  if (!options.against.empty()) {
    refuse_for_motion(options, {{"--html", options.html},
                                {"--corrected", options.corrected},
                                {"--next", options.next ? "yes" : ""}});
    return diagnose_motion_change({options.input(), options.against, options.json, "", options.check}, verb);
  }
  if (options.plan) {
    refuse_for_motion(options, {{"--change", options.change}});
    return plan_motion(options.experiments.front(), options.json, verb);
  }
  refuse_for_motion(options, {});
  diagnose_motion(options.experiments.front(), {options.json, options.html, options.corrected}, options.next,
                  verb);
}

void run_torques(const DiagnoseOptions& options, const CLI::App& verb) {
  refuse_for_motion(options, {{"--html", options.html},
                              {"--corrected", options.corrected},
                              {"--against", options.against},
                              {"--plan", options.plan ? "yes" : ""},
                              {"--next", options.next ? "yes" : ""}});
  balance_torques(options.experiments.front(), options.json, verb);
}

void run(const DiagnoseOptions& options, const CLI::App& verb) {
  if (options.experiments.size() == 1 && options.reports.empty() && is_motion(options.experiments.front()))
    return run_motion(options, verb);
  if (options.experiments.size() == 1 && options.reports.empty() &&
      is_of_torques(options.experiments.front()))
    return run_torques(options, verb);
  if (options.plan) return run_plan(options, verb);
  if (options.since)
    return diagnose_since({options.experiments, options.model, options.effects, options.json, options.html},
                          verb);
  if (options.experiments.size() > 1 || !options.reports.empty()) return run_many(options, verb);
  if (options.against.empty()) return run_diagnosis(options, verb);
  diagnose_change({options.input(), options.against, options.json, options.html, options.check}, verb);
}

}  // namespace

void add_diagnose(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("diagnose",
                                      "Where the gap between an experiment and its model lies, what causes "
                                      "it, how far a correction reduces it");
  const auto options = std::make_shared<DiagnoseOptions>();
  verb->add_option(
          "experiment", options->experiments,
          "A folder with experiment.toml and its sample files. Without it: a small bundled example. Of "
          "several, each is diagnosed, and a report for all says whether the cause is the same, how its "
          "parameter scatters and whether it drifts")
      ->type_name("FOLDER");
  verb->add_option("--effects", options->effects,
                   "A TOML file with your own effects, as expressions, beside those of the catalogue")
      ->type_name("FILE");
  verb->add_option(
          "--model", options->model,
          "The nominal model, instead of the experiment's own: .toml, as --corrected writes it, or a "
          "simulator's: .xml (MJCF), .urdf, .sdf")
      ->type_name("FILE");
  auto* corrected =
      add_output(*verb, "--corrected", options->corrected,
                 "Write the nominal model with what was found: .toml (ours), .xml (MJCF), .urdf "
                 "or .sdf. One file a candidate where the cause is ambiguous");
  add_printed_output(*verb, "--json", options->json,
                     "Write the report as JSON too (without FILE: to standard output alone)");
  auto* html = add_output(*verb, "--html", options->html,
                          "Write a page with curves, residuals and the chain: one file, to print or send");
  auto* against = verb->add_option("--against", options->against,
                                   "What changed since: another data set of the same device, with the same "
                                   "nominal model. What the model lacks in both cancels. Or a state "
                                   "that runs of this experiment name, against the other one")
                      ->type_name("FOLDER|STATE");
  auto* since = verb->add_flag("--since", options->since,
                               "What changed since when: several experiments, or the states that runs of one "
                               "name, in the order of time, each against the first");
  auto* check = verb->add_flag("--check", options->check,
                               "With --against: exit status 0 for no change, 1 for a change, 2 where the "
                               "readings cannot tell")
                    ->needs(against);
  auto* reports = add_output(
      *verb, "--reports", options->reports,
      "Keep the report of each of several experiments in this folder, as NAME.json and NAME.html", "DIR");
  auto* next =
      verb->add_flag("--next", options->next,
                     "Propose the next run even where the cause is clear: to distinguish the best two");
  auto* as_is =
      verb->add_flag("--as-is", options->as_is, "Accept numbers that look like another unit, sign or axis");
  auto* plan = verb->add_flag(
      "--plan", options->plan,
      "Before any data, from experiment.toml, whose runs may be without samples or hold commands "
      "alone: which effects the bench cannot detect, which it cannot distinguish, and the fewest "
      "runs that distinguish the rest. Of a joint in motion: the same of the motions that [[motion]] lists");
  verb->add_option(
          "--change", options->change,
          "With --plan: the fewest runs that, made once more, would show a change of this size, such as "
          "joint_friction=0.05 or \"joint_stop(2)=0.3,2\"")
      ->type_name("EFFECT=VALUES")
      ->needs(plan);
  for (CLI::Option* other : {corrected, html, reports, next, as_is, against, since}) plan->excludes(other);
  for (CLI::Option* other : {corrected, reports, next, against, check}) since->excludes(other);
  for (CLI::Option* other : {corrected, next}) against->excludes(other);
  check->excludes(reports);
  verb->footer(
      "Exit status 1 when one of several experiments could not be diagnosed; the others are reported.");
  verb->callback([options, verb] { run(*options, *verb); });
}

}  // namespace plumbline::app
