#include "app/diagnose_many.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <plumbline/base/error.hpp>
#include <set>

#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/results_folder.hpp"
#include "diagnose/bench/read_date.hpp"
#include "diagnose/campaign/report.hpp"
#include "support/files/experiment_files.hpp"
#include "support/files/output_file.hpp"

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

/// Every file that is read.
std::vector<fs::path> files_read(const ManyExperiments& many, const std::vector<fs::path>& folders) {
  std::vector<fs::path> all(many.inputs.begin(), many.inputs.end());
  for (const fs::path& folder : folders)
    for (const fs::path& file : files::files_read(folder)) all.push_back(file);
  return all;
}

std::vector<campaign::Outcome> diagnosed(const ManyExperiments& many, const std::vector<fs::path>& folders,
                                         ResultsFolder& reports) {
  Progress progress("diagnoses", folders.size());
  const campaign::Work work{many.words,
                            {many.inputs.begin(), many.inputs.end()},
                            reports.path(),
                            !many.reports.empty(),
                            reports.journal()};
  std::vector<campaign::Outcome> outcomes =
      campaign::diagnose_all(folders, work, [&] { progress.advance(); });
  for (std::size_t i = 0; i < folders.size(); ++i) outcomes[i].date = diagnose::date_of(folders[i]);
  return outcomes;
}

/// \throws Error for a repeated folder, which would count as two benches that agree
void require_different(const std::vector<fs::path>& folders) {
  std::set<fs::path> known;
  for (const fs::path& folder : folders) {
    std::error_code unreadable;  // which is told where it is read
    const fs::path one = fs::weakly_canonical(folder / "", unreadable);
    if (!unreadable && !known.insert(one).second)
      throw Error(folder.string(), "this folder again", "each experiment once");
  }
}

}  // namespace

void diagnose_many(const ManyExperiments& many, const CLI::App& verb) {
  std::vector<fs::path> folders;
  std::vector<std::string> passed_over;
  for (const std::string& path : many.folders) {
    if (fs::exists(path) && !fs::is_directory(path)) {
      passed_over.push_back(path);
    } else {
      folders.emplace_back(path);
    }
  }
  if (folders.empty()) throw Error(many.folders.front(), "no folder", "folders of experiments");
  require_different(folders);
  Outputs outputs(verb, files_read(many, folders));
  files::OutputFile *const json = outputs.open("--json", many.json), *const html =
                                                                         outputs.open("--html", many.html);
  if (!many.reports.empty()) files::require_folder(many.reports);
  ResultsFolder reports("--reports", many.reports, "plumbline diagnose");
  const std::vector<campaign::Outcome> outcomes = diagnosed(many, folders, reports);
  const campaign::Comparison comparison = campaign::compare(outcomes);
  const page::Provenance& from = outputs.provenance();
  if (json) json->write(page::json_text(campaign::as_json(outcomes, comparison), from));
  if (html) html->write(page::on_page(campaign::as_html(outcomes, comparison), from));
  outputs.commit();
  if (reports.journal()) reports.journal()->finish();
  if (many.json != "-" && many.html != "-") {
    fmt::print("{}", campaign::as_text(outcomes, comparison));
    if (!passed_over.empty())
      fmt::print("\nPassed over, being no folders: {}\n", fmt::join(passed_over, ", "));
  }
  if (comparison.failed > 0) throw CLI::RuntimeError(1);
}

}  // namespace plumbline::app
