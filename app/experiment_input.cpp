#include "app/experiment_input.hpp"

#include <map>
#include <optional>

#include "app/example_files.hpp"
#include "diagnose/bench/decimate.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/change/states.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/rig/user_effects/read_effects.hpp"
#include "support/files/experiment_files.hpp"
#include "support/files/text_file.hpp"
#include "support/files/toml_file.hpp"

namespace plumbline::app {
namespace {

std::string example_file(const std::string& name, const std::string&) {
  std::map<std::string, std::string> files;
  for (const auto& [known, text] : example_files) files.emplace(known, text);
  return files.at(name);
}

constexpr const char* example_folder = "docs/examples/experiment";

std::optional<diagnose::NominalChain> model_of(const ExperimentInput& input) {
  if (input.model.empty()) return std::nullopt;
  return exchange::read_model(input.model).chain;
}

}  // namespace

std::vector<std::filesystem::path> ExperimentInput::files() const {
  std::vector<std::filesystem::path> all = files::files_read(folder);
  all.insert(all.end(), {model, effects});
  return all;
}

diagnose::Experiment experiment_of(const ExperimentInput& input) {
  const std::optional<diagnose::NominalChain> model = model_of(input);
  const diagnose::NominalChain* const nominal = model ? &*model : nullptr;
  if (input.folder.empty()) return diagnose::read_experiment(example_folder, example_file, nominal);
  exchange::ArmReader arms;
  if (input.state.empty())
    return arms.with_effects(diagnose::read_experiment(input.folder, nominal, arms.read()));
  diagnose::Experiment experiment = arms.with_effects(diagnose::read_experiment(
      input.folder, diagnose::settings_of(input.folder, input.state), nominal, arms.read()));
  experiment.name = input.state;
  return experiment;
}

diagnose::Experiment bench_of(const ExperimentInput& input) {
  const std::optional<diagnose::NominalChain> model = model_of(input);
  const diagnose::NominalChain* const nominal = model ? &*model : nullptr;
  if (input.folder.empty()) return diagnose::read_plan(example_folder, example_file, nominal);
  exchange::ArmReader arms;
  return arms.with_effects(diagnose::read_plan(input.folder, nominal, arms.read()));
}

std::filesystem::path model_file(const ExperimentInput& input) {
  if (!input.model.empty() || input.folder.empty()) return input.model;
  const std::filesystem::path folder = input.folder, settings = folder / "experiment.toml";
  const toml::table table = files::parse_toml(files::read_text(settings), settings.string());
  const auto file = table["arm"]["model"].value<std::string>();
  return file ? folder / *file : std::filesystem::path();
}

diagnose::Study study_of(const ExperimentInput& input, const diagnose::Experiment& experiment) {
  return diagnose::study_with(decimated(experiment),
                              input.effects.empty()
                                  ? std::vector<diagnose::StatedEffect>{}
                                  : diagnose::read_effects(input.effects, experiment.covariates));
}

}  // namespace plumbline::app
