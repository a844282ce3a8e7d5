#include "app/diagnose_change.hpp"

#include <fmt/core.h>

#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "diagnose/change/change_report.hpp"
#include "diagnose/report/report.hpp"

namespace plumbline::app {

void diagnose_change(const ChangeOptions& options, const CLI::App& verb) {
  const diagnose::StudyFiles before{options.before, options.after.model, options.after.effects};
  const diagnose::Experiment first = experiment_of(before), second = experiment_of(options.after);
  std::vector<std::filesystem::path> inputs = options.after.all();
  for (const std::filesystem::path& file : before.all()) inputs.push_back(file);
  Outputs outputs(verb, inputs);
  files::OutputFile *const json = outputs.open("--json", options.json), *const html = outputs.open(
                                                                            "--html", options.html);
  const diagnose::Change change = with_progress("change", [&](const auto& show) {
    return diagnose::what_changed(study_of(first, before.effects), study_of(second, options.after.effects),
                                  show);
  });
  const page::Provenance& from = outputs.provenance();
  if (json) json->write(page::json_text(as_json(change), from));
  if (html) html->write(page::on_page(diagnose::as_html(change.study, change.diagnosis), from));
  outputs.commit();
  if (options.json != "-" && options.html != "-") fmt::print("{}", as_text(change));
  if (const int status = static_cast<int>(check(change)); options.check && status != 0)
    throw CLI::RuntimeError(status);
}

}  // namespace plumbline::app
