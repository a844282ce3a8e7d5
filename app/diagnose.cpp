#include <fmt/core.h>

#include <memory>

#include "app/example_experiment.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/report/report.hpp"
#include "trial/experiment_files.hpp"

namespace plumbline::app {
namespace {

struct Options {
  std::string experiment, json, html;
  bool next = false;
};

diagnose::Diagnosis diagnosis_of(const diagnose::Study& study, bool next) {
  constexpr std::size_t steps = 100;
  Progress progress("diagnosis", steps);
  std::size_t shown = 0;
  const auto show = [&](double share) {
    for (; shown < static_cast<std::size_t>(share * steps); ++shown) progress.advance();
  };
  return diagnose::diagnose(study, show, next);
}

void run(const Options& options) {
  diagnose::Experiment experiment =
      options.experiment.empty() ? example_experiment() : diagnose::read_experiment(options.experiment);
  Outputs outputs(trial::files_read(options.experiment));
  files::OutputFile *const json = outputs.open("--json", options.json), *const html = outputs.open(
                                                                            "--html", options.html);
  const diagnose::Study study(std::move(experiment));
  const diagnose::Diagnosis diagnosis = diagnosis_of(study, options.next);
  if (json) json->write(as_json(diagnosis).dump(2) + "\n");
  if (html) html->write(diagnose::as_html(study, diagnosis));
  outputs.commit();
  if (options.json != "-" && options.html != "-") fmt::print("{}", as_text(diagnosis));
}

}  // namespace

void add_diagnose(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "diagnose",
      "Where the gap between an experiment and its model lies, what causes it, how far it shrinks");
  const auto options = std::make_shared<Options>();
  verb->add_option("experiment", options->experiment,
                   "A folder with experiment.toml and its sample files. Without it: a small bundled example")
      ->type_name("FOLDER");
  verb->add_option("--json", options->json,
                   "Write the report as JSON too (without FILE: to standard output alone)")
      ->type_name("[FILE]")
      ->expected(0, 1)
      ->default_str("-");
  verb->add_option(
          "--html", options->html,
          "Write a page with the curves, the residuals and the chain drawn: one file, to print or send")
      ->type_name("FILE");
  verb->add_flag("--next", options->next,
                 "Say which run to make next even where the cause is clear: to tell the best two apart");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
