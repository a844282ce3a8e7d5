#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <plumbline/base/error.hpp>

#include "app/diagnose_change.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "diagnose/bench/read_date.hpp"
#include "diagnose/bench/states.hpp"
#include "diagnose/campaign/report.hpp"
#include "diagnose/change/change_report.hpp"
#include "support/files/json_file.hpp"

namespace plumbline::app {
namespace {

/// One data set in time.
struct Moment {
  diagnose::StudyFiles input;
  std::string name;
  std::optional<campaign::Day> date;
};

/// The states of one folder as its runs name them, or the folders by their dates.
std::vector<Moment> moments_of(const SinceOptions& options) {
  std::vector<Moment> all;
  if (options.folders.size() == 1) {
    const std::string& folder = options.folders.front();
    for (const std::string& state : diagnose::states_in(folder))
      all.push_back({{folder, options.model, options.effects, state}, state, std::nullopt});
  } else {
    const std::vector<std::string> names =
        campaign::names_of({options.folders.begin(), options.folders.end()});
    for (std::size_t i = 0; i < names.size(); ++i)
      all.push_back({{options.folders[i], options.model, options.effects, ""},
                     names[i],
                     diagnose::date_of(options.folders[i])});
  }
  if (all.size() < 2)
    throw Error("--since", fmt::format("{} data sets", all.size()),
                "several folders, or one whose runs name several states");
  if (std::all_of(all.begin(), all.end(), [](const Moment& one) { return one.date.has_value(); }))
    std::stable_sort(all.begin(), all.end(),
                     [](const Moment& a, const Moment& b) { return *a.date < *b.date; });
  return all;
}

std::vector<std::filesystem::path> files_of(const std::vector<Moment>& moments) {
  std::vector<std::filesystem::path> files;
  for (const Moment& one : moments)
    if (&one == &moments.front() || one.input.folder != moments.front().input.folder)
      for (const std::filesystem::path& file : one.input.all()) files.push_back(file);
  return files;
}

campaign::Outcome since_first(const Moment& first, const Moment& later,
                              const std::function<void(double)>& show) {
  campaign::Outcome outcome{later.name, later.date, "", {}};
  try {
    const diagnose::Study before = study_of(experiment_of(first.input), first.input.effects),
                          after = study_of(experiment_of(later.input), later.input.effects);
    const diagnose::Change change = diagnose::what_changed(before, after, show);
    outcome.report = campaign::report_from(nlohmann::json(as_json(change)), later.name);
  } catch (const Error& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

}  // namespace

void diagnose_since(const SinceOptions& options, const CLI::App& verb) {
  const std::vector<Moment> moments = moments_of(options);
  Outputs outputs(verb, files_of(moments));
  files::OutputFile *const json = outputs.open("--json", options.json), *const html = outputs.open(
                                                                            "--html", options.html);
  const std::vector<campaign::Outcome> outcomes = with_progress("since", [&](const auto& show) {
    std::vector<campaign::Outcome> all;
    const auto count = static_cast<double>(moments.size() - 1);
    for (std::size_t i = 1; i < moments.size(); ++i)
      all.push_back(since_first(moments.front(), moments[i], [&, i](double share) {
        show((static_cast<double>(i - 1) + share) / count);
      }));
    return all;
  });
  const campaign::Comparison comparison = campaign::compare(outcomes);
  const std::vector<campaign::Since> since = campaign::since_when(outcomes);
  const page::Provenance& from = outputs.provenance();
  if (json) {
    nlohmann::ordered_json report = campaign::as_json(outcomes, comparison);
    report["since"] = campaign::as_json(since, outcomes);
    json->write(page::json_text(std::move(report), from));
  }
  if (html) html->write(page::on_page(campaign::as_html(outcomes, comparison, since), from));
  outputs.commit();
  if (options.json != "-" && options.html != "-")
    fmt::print("Against {}: {}\n{}", moments.front().name, campaign::as_text(outcomes, comparison),
               campaign::as_text(since, outcomes));
  if (comparison.failed > 0) throw CLI::RuntimeError(1);
}

}  // namespace plumbline::app
