#include "app/diagnose_motion.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "app/corrected_files.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "diagnose/motion/balance/balance_report.hpp"
#include "diagnose/motion/corrected_joint.hpp"
#include "diagnose/motion/motion_plan_report.hpp"
#include "diagnose/motion/page.hpp"
#include "diagnose/motion/read_bench.hpp"
#include "diagnose/motion/report.hpp"

namespace plumbline::app {
namespace {

bool has_settings(const std::string& folder) {
  return !folder.empty() &&
         std::filesystem::is_regular_file(std::filesystem::path(folder) / "experiment.toml");
}

}  // namespace

bool is_motion(const std::string& folder) {
  return has_settings(folder) && motion::is_motion(folder);
}

bool is_of_torques(const std::string& folder) {
  return has_settings(folder) && motion::is_torque_bench(folder);
}

void balance_torques(const std::string& folder, const std::string& json, const CLI::App& verb) {
  Outputs outputs(verb, {std::filesystem::path(folder) / "experiment.toml"});
  files::OutputFile* const file = outputs.open("--json", json);
  const motion::Balance balance = motion::balance_of(motion::read_torque_bench(folder));
  if (file) file->write(page::json_text(as_json(balance), outputs.provenance()));
  outputs.commit();
  if (json != "-") fmt::print("{}", as_text(balance));
}

void diagnose_motion(const std::string& folder, const MotionFiles& files, bool next, const CLI::App& verb) {
  Outputs outputs(verb, {std::filesystem::path(folder) / "experiment.toml"});
  files::OutputFile *const json = outputs.open("--json", files.json),
                           *const html = outputs.open("--html", files.html),
                           *const model = outputs.open("--corrected", files.corrected);
  const motion::Study study(motion::read_bench(folder));
  const motion::Diagnosis diagnosis =
      with_progress("diagnosis", [&](const auto& show) { return motion::diagnose_motion(study, show); });
  exchange::Written written;
  if (model) {
    written = motion::corrected_joint(study.bench(), diagnosis, files.corrected);
    model->write(written.text);
  }
  if (json) json->write(page::json_text(as_json(diagnosis), outputs.provenance()));
  if (html) html->write(page::on_page(as_html(study.bench(), diagnosis), outputs.provenance()));
  outputs.commit();
  if (files.json != "-" && files.html != "-")
    fmt::print("{}{}{}", as_text(diagnosis),
               next || diagnosis.verdict == diagnose::CauseVerdict::ambiguous ? next_text(diagnosis) : "",
               model ? as_text(files.corrected, written) : "");
}

void plan_motion(const std::string& folder, const std::string& json, const CLI::App& verb) {
  Outputs outputs(verb, {std::filesystem::path(folder) / "experiment.toml"});
  files::OutputFile* const file = outputs.open("--json", json);
  const motion::Bench bench = motion::read_planned_bench(folder);
  const motion::MotionPlan plan =
      with_progress("plan", [&](const auto& show) { return motion::plan_of(bench, show); });
  if (file) file->write(page::json_text(as_json(plan), outputs.provenance()));
  outputs.commit();
  if (json != "-") fmt::print("{}", as_text(plan));
}

}  // namespace plumbline::app
