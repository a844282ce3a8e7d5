#include "app/serve/work_bench.hpp"

#include <algorithm>
#include <filesystem>
#include <plumbline/base/error.hpp>

#include "app/command.hpp"
#include "app/serve/first_charts.hpp"
#include "diagnose/api/example_files.hpp"
#include "diagnose/api/report.hpp"
#include "diagnose/api/study_files.hpp"
#include "diagnose/draft/told_columns.hpp"
#include "diagnose/screening/conventions.hpp"
#include "support/files/output_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"
#include "support/page/provenance.hpp"

namespace plumbline::app {
namespace {

using nlohmann::json;

struct Cancelled {};

/// A name that a browser gave: of a file in our folder, and nothing else.
std::string own_name(const std::string& given) {
  const std::size_t slash = given.find_last_of("/\\");
  const std::string name = slash == std::string::npos ? given : given.substr(slash + 1);
  constexpr std::size_t longest = 100;
  const bool plain = !name.empty() && name.front() != '.' && name.size() <= longest &&
                     files::printable(name) == name && name.find('"') == std::string::npos;
  if (!plain || name == "experiment.toml" || name == "experiment.schema.json")
    throw Error("a file", "the name " + files::shown(given), "a plain one");
  return name;
}

json guesses_of(const diagnose::Guesses& guesses) {
  json list = json::array();
  for (const diagnose::Guess& one : guesses)
    list.push_back(
        {{"what", one.what}, {"value", one.value}, {"reason", one.reason}, {"doubtful", one.doubtful}});
  return list;
}

json columns_of(const diagnose::SeenTable& table) {
  json list = json::array();
  for (const diagnose::SeenColumn& one : table.columns)
    list.push_back({{"title", one.title},
                    {"name", one.name},
                    {"channel", one.channel},
                    {"unit", one.unit},
                    {"sign", one.sign},
                    {"told", one.told},
                    {"first", one.first}});
  return list;
}

/// What a person may say that a column holds.
json choices() {
  json list = json::array();
  for (const diagnose::ChannelChoice& one : diagnose::channel_choices())
    list.push_back(
        {{"word", one.word}, {"means", one.means}, {"numbered", one.numbered}, {"units", one.units}});
  return list;
}

}  // namespace

json WorkBench::take(const NamedFile& model, const std::vector<NamedFile>& tables,
                     const std::vector<std::string>& joints, const std::string& columns) {
  cancel();
  place_.emplace();
  model_ = own_name(model.name);
  files::write_text(*place_ / model_, model.text);
  read_ = diagnose::read_draft_model(*place_ / model_, joints);
  std::vector<diagnose::DraftFile> drafted;
  for (const NamedFile& table : tables) {
    const std::string name = own_name(table.name);
    drafted.push_back({name, table.text});
  }
  const std::vector<diagnose::ToldColumn> told = diagnose::told_columns(columns);
  seen_ = diagnose::seen_tables(drafted, read_.model.names(), told);
  try {
    draft_ = diagnose::draft_experiment(model_.substr(0, model_.find_last_of('.')), read_.model, drafted, {},
                                        told);
  } catch (const Error& question) {  // the tables are there to be told
    if (seen_.empty()) throw;
    draft_ = {};
    draft_.question = in_own_names(question.what());
  }
  write_draft(draft_, place_->path());
  outcome_ = {};
  return described();
}

json WorkBench::take_example() {
  cancel();
  place_.emplace();
  model_.clear();
  read_ = {};
  draft_ = {};
  seen_.clear();
  for (const auto& [name, text] : diagnose::example_files) {
    if (std::string(name) == "experiment.toml") {
      draft_.settings = text;
    } else {
      draft_.tables.push_back({name, text});
    }
  }
  write_draft(draft_, place_->path());
  outcome_ = {};
  return described();
}

json WorkBench::correct(const std::string& settings) {
  if (!place_) throw Error("experiment", "no files yet", "a model and tables, or the example");
  files::require_text(settings, "experiment.toml");
  cancel();
  draft_.settings = settings;
  draft_.question.clear();
  files::write_text(*place_ / "experiment.toml", settings);
  return described();
}

/// As it is read now: what is wrong is said, and is no failure.
json WorkBench::described() const {
  json result{{"notes", read_.notes(draft_.bench)},
              {"guesses", guesses_of(draft_.guesses)},
              {"settings", draft_.settings},
              {"question", draft_.question},
              {"joints", std::max(read_.model.names().size(), read_.model.chain.link_length.size())},
              {"channels", choices()},
              {"tables", json::array()},
              {"charts", json::array()}};
  for (const diagnose::SeenTable& table : seen_)
    result["tables"].push_back({{"file", table.file}, {"columns", columns_of(table)}});
  if (draft_.settings.empty()) return result;
  try {
    const diagnose::Experiment experiment = diagnose::experiment_of({place_->path(), {}, {}});
    const diagnose::Study study = diagnose::study_of(experiment);
    for (const diagnose::PageChart& one : first_charts(study))
      result["charts"].push_back({{"caption", one.caption}, {"svg", one.svg}});
    require_conventions(study);
  } catch (const Error& question) {
    result["question"] = in_own_names(question.what());
  }
  return result;
}

std::string WorkBench::in_own_names(std::string text) const {
  if (!place_) return text;
  const std::string folder = place_->path().string() + "/";
  for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
  return text;
}

json WorkBench::begin(bool as_is) {
  if (!place_) throw Error("experiment", "no files yet", "a model and tables, or the example");
  cancel();
  {
    const std::lock_guard lock(mutex_);
    outcome_ = {State::busy, "", "", {}};
  }
  share_ = 0;
  job_ = std::jthread([this, as_is](const std::stop_token& stop) { diagnose(as_is, stop); });
  return progress();
}

void WorkBench::diagnose(bool as_is, const std::stop_token& stop) {
  Outcome outcome{State::done, "", "", {}};
  try {
    const diagnose::Experiment experiment = diagnose::experiment_of({place_->path(), {}, {}});
    const auto progress = [&](double share) {
      if (stop.stop_requested()) throw Cancelled();
      share_ = share;
    };
    const diagnose::Report report(diagnose::study_of(experiment), {as_is, false, progress});
    outcome.words = report.text();
    const page::Provenance from{program_name(), "plumbline diagnose, on the page", ""};
    outcome.page = page::on_page(report.html(), from);
    const std::filesystem::path source = model_.empty() ? "" : *place_ / model_;
    const std::string ending = model_.empty() ? ".toml" : source.extension().string();
    for (const exchange::Corrected& one : report.corrected(source)) {
      const std::string stem = (model_.empty() ? std::string("model") : source.stem().string()) +
                               "-corrected" + (one.cause.empty() ? "" : "-" + one.cause);
      for (const std::string& format : {ending, std::string(".toml")}) {
        if (format == ".toml" && ending == ".toml" && !outcome.models.empty() &&
            outcome.models.back().name == stem + ".toml")
          continue;
        outcome.models.push_back(
            {stem + format, exchange::written(one.model, exchange::format_of("x" + format)).text});
      }
    }
  } catch (const Cancelled&) {
    outcome = {State::cancelled, "given up", "", {}};
  } catch (const std::exception& error) {
    outcome = {State::failed, in_own_names(error.what()), "", {}};
  }
  const std::lock_guard lock(mutex_);
  outcome_ = std::move(outcome);
}

json WorkBench::progress() const {
  const std::lock_guard lock(mutex_);
  constexpr const char* names[] = {"nothing", "busy", "done", "failed", "cancelled"};
  json models = json::array();
  for (const NamedFile& one : outcome_.models) models.push_back(one.name);
  return {{"state", names[static_cast<int>(outcome_.state)]},
          {"share", share_.load()},
          {"words", outcome_.words},
          {"models", models}};
}

void WorkBench::cancel() {
  if (!job_.joinable()) return;
  job_.request_stop();
  job_.join();
}

std::string WorkBench::report() const {
  const std::lock_guard lock(mutex_);
  return outcome_.page;
}

std::vector<NamedFile> WorkBench::corrected() const {
  const std::lock_guard lock(mutex_);
  return outcome_.models;
}

std::vector<NamedFile> WorkBench::folder() const {
  std::vector<NamedFile> all;
  if (!place_) return all;
  for (const diagnose::DraftFile& file : files_of(draft_)) all.push_back({file.name, file.text});
  const auto is_model = [this](const NamedFile& file) { return file.name == model_; };
  if (!model_.empty() && std::none_of(all.begin(), all.end(), is_model))
    all.push_back({model_, files::read_text(*place_ / model_)});
  return all;
}

}  // namespace plumbline::app
