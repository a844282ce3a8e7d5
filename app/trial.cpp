#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <plumbline/base/error.hpp>

#include "app/arguments.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/results_folder.hpp"
#include "app/secret_experiments.hpp"
#include "app/verbs.hpp"
#include "diagnose/rig/effect.hpp"
#include "support/files/experiment_files.hpp"
#include "support/files/output_file.hpp"
#include "trial/report.hpp"
#include "trial/run_trial.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

constexpr double usual_patience = 30;  // s for one diagnosis

struct TrialOptions {
  std::size_t trials = 20;
  std::uint64_t seed = 1;
  bool second = false;
  std::string out, experiments, json, markdown;
  double patience = usual_patience;
};

/// The command that reproduces the result.
std::string command(const TrialOptions& options) {
  const std::string patience =
      options.patience == usual_patience ? "" : fmt::format(" --patience {}", options.patience);
  if (!options.experiments.empty()) return "plumbline trial --experiments " + options.experiments + patience;
  return fmt::format("plumbline trial {}--trials {} --seed {}{}", options.second ? "--second " : "",
                     options.trials, options.seed, patience);
}

/// The folder of the trial: the user's, new, empty or with the same trial unfinished, or a temporary one.
ResultsFolder place_of(const TrialOptions& options) {
  const fs::path folder = options.out;
  if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / work::unfinished_name))
    throw Error(options.out, "something there already", "a new or an empty folder, or a trial to go on with");
  return {"--out", options.out, command(options)};
}

SecretExperiments make(const TrialOptions& options, const fs::path& folder) {
  Progress progress("experiments", options.trials);
  return make_experiments(options.second ? BlindTrial::second : BlindTrial::first, options.trials,
                          options.seed, folder, [&] { progress.advance(); });
}

std::vector<campaign::Diagnosed> diagnose_all(const TrialOptions& options, const trial::SealedFolder& folder,
                                              const fs::path& reports, work::Journal* journal) {
  Progress progress("diagnoses", folder.names().size());
  return trial::diagnose_all(folder, reports, std::chrono::duration<double>(options.patience), journal,
                             [&] { progress.advance(); });
}

/// The effects that this program's diagnosis can name.
trial::Catalogue catalogue() {
  trial::Catalogue all;
  for (const diagnose::Effect& row : diagnose::catalogue())
    all.emplace(row.id + (row.at_joint ? "(j)" : ""), row.id);
  for (const auto& [former, now] : diagnose::former_ids()) all.emplace(former, now);
  return all;
}

trial::Circumstances circumstances(const TrialOptions& options, const trial::SealedFolder& folder,
                                   const SecretExperiments& secret) {
  trial::Circumstances all{command(options), folder.digest(), folder.sealed(), secret.nominal_errors.size()};
  std::vector<double> errors = secret.nominal_errors;
  std::sort(errors.begin(), errors.end());
  if (errors.empty()) return all;
  all.median_error = errors[errors.size() / 2];
  all.worst_error = errors.back();
  return all;
}

void run(const TrialOptions& options, const CLI::App& verb) {
  Outputs outputs(verb, files::files_of(options.experiments));
  files::OutputFile *const json = outputs.open("--json", options.json), *const markdown = outputs.open(
                                                                            "--markdown", options.markdown);
  const bool quiet = options.json == "-" || options.markdown == "-";
  ResultsFolder place = place_of(options);
  SecretExperiments secret;
  if (options.experiments.empty()) secret = make(options, place.path());
  const trial::SealedFolder folder(options.experiments.empty() ? place.path()
                                                               : fs::path(options.experiments));
  if (!options.experiments.empty())
    for (const std::string& name : folder.names()) static_cast<void>(folder.open(name));
  if (folder.sealed() > 0 && !quiet) {
    fmt::print("{} experiments, their labels sealed. SHA-256 of the seals: {}\n\n", folder.sealed(),
               folder.digest());
    std::fflush(stdout);
  }
  const fs::path reports = place.path() / "reports";
  const std::vector<campaign::Diagnosed> diagnosed = diagnose_all(options, folder, reports, place.journal());
  publish(secret, place.path());
  const std::vector<trial::Case> cases = trial::unseal(folder, reports, diagnosed, catalogue());
  const trial::Circumstances about = circumstances(options, folder, secret);
  const page::Provenance& from = outputs.provenance();
  if (json) json->write(page::json_text(trial::as_json(about, cases), from));
  if (markdown)
    markdown->write(page::in_markdown(trial::as_text(about, cases, trial::Style::markdown), from));
  outputs.commit();
  if (place.journal()) place.journal()->finish();
  if (!quiet) fmt::print("{}", trial::as_text(about, cases, trial::Style::terminal));
  const trial::Score score = trial::score(cases);
  if (score.broken_seals + score.no_report > 0) throw CLI::RuntimeError(1);
}

}  // namespace

void add_trial(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "trial", "The blind trial: experiments with sealed causes are diagnosed, unsealed and scored");
  const auto options = std::make_shared<TrialOptions>();
  auto* trials =
      verb->add_option("--trials", options->trials, "Number of experiments that the simulated rig makes")
          ->check(whole_number(1, 100000))
          ->capture_default_str();
  auto* seed = verb->add_option("--seed", options->seed, "Of the random numbers")
                   ->check(whole_number(0))
                   ->capture_default_str();
  auto* second =
      verb->add_flag("--second", options->second,
                     "The second trial: a third outside the catalogue, a third with values of their own at "
                     "each joint or tolerances, and noise to twice the declared and beyond");
  verb->add_option("--experiments", options->experiments,
                   "Diagnose and score the experiments in this folder instead: NAME/experiment.toml with "
                   "NAME/label.json, or sealed (trial/README.md)")
      ->type_name("DIR")
      ->excludes(trials)
      ->excludes(seed)
      ->excludes(second);
  add_output(
      *verb, "--out", options->out,
      "Keep experiments, seals, reports and labels in this folder; an interrupted trial continues there",
      "DIR");
  verb->add_option("--patience", options->patience, "Seconds after which a diagnosis is given up")
      ->check(number(0.001, 1e6))
      ->capture_default_str();
  add_printed_output(*verb, "--json", options->json,
                     "Write the result as JSON too (without FILE: to standard output alone)");
  add_output(*verb, "--markdown", options->markdown, "Write the result as Markdown too");
  verb->footer("Exit status 1 when a seal is broken or a diagnosis leaves no report.");
  verb->callback([options, verb] { run(*options, *verb); });
}

}  // namespace plumbline::app
