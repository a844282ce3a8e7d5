#include "diagnose/api/study_files.hpp"

#include <map>
#include <optional>
#include <plumbline/base/error.hpp>

#include "diagnose/api/example_files.hpp"
#include "diagnose/bench/decimate.hpp"
#include "diagnose/bench/read_experiment.hpp"
#include "diagnose/bench/states.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/inference/imposed_noise.hpp"
#include "diagnose/rig/user_effects/read_effects.hpp"
#include "support/files/experiment_files.hpp"
#include "support/files/text_file.hpp"
#include "support/files/toml_file.hpp"

namespace plumbline::diagnose {
namespace {

std::string example_file(const std::string& name, const std::string&) {
  std::map<std::string, std::string> files;
  for (const auto& [known, text] : example_files) files.emplace(known, text);
  return files.at(name);
}

constexpr const char* example_folder = "docs/examples/experiment";

/// The table of an arm in space; none of a bench in a plane, or where there is none.
std::optional<toml::table> arm_of(const StudyFiles& files) {
  const std::string settings = (files.folder / "experiment.toml").string();
  if (files.folder.empty() || !std::filesystem::exists(settings)) return std::nullopt;
  const toml::table all = files::parse_toml(files::read_text(settings), settings);
  const toml::table* arm = all["arm"].as_table();
  return arm ? std::optional(*arm) : std::nullopt;
}

/// A planar model in place of the nominal chain.
std::optional<NominalChain> model_of(const StudyFiles& files) {
  if (files.model.empty() || arm_of(files)) return std::nullopt;
  return exchange::read_model(files.model).chain;
}

/// A reader of the model that an arm's settings name, or of the one in place of it.
ReadArm reader_of(const StudyFiles& files, exchange::ArmReader& arms) {
  if (files.model.empty()) return arms.read();
  const std::optional<toml::table> arm = arm_of(files);
  if (!arm) return arms.read();
  if (!(*arm)["model"].is_string())
    throw Error(files.model.string(), "a model of an arm whose joints experiment.toml tells",
                "an experiment whose arm.model names a file");
  return [read = arms.read(), model = files.model.string()](const std::string&, const std::string& base,
                                                            const std::string& tip) {
    return read(model, base, tip);
  };
}

/// The runs of one state.
Experiment state_of(const StudyFiles& files, const NominalChain* nominal, const ReadArm& arm) {
  Experiment experiment = read_experiment(files.folder, settings_of(files.folder, files.state), nominal, arm);
  experiment.name = files.state;
  return experiment;
}

}  // namespace

std::vector<std::filesystem::path> StudyFiles::all() const {
  std::vector<std::filesystem::path> all = files::files_read(folder);
  all.insert(all.end(), {model, effects});
  return all;
}

std::filesystem::path StudyFiles::nominal_model() const {
  if (!model.empty() || folder.empty()) return model;
  const std::optional<toml::table> arm = arm_of(*this);
  const auto file = arm ? (*arm)["model"].value<std::string>() : std::nullopt;
  return file ? folder / *file : std::filesystem::path();
}

Experiment experiment_of(const StudyFiles& files) {
  const std::optional<NominalChain> model = model_of(files);
  const NominalChain* const nominal = model ? &*model : nullptr;
  if (files.folder.empty()) return read_experiment(example_folder, example_file, nominal);
  exchange::ArmReader arms;
  return arms.with_effects(files.state.empty()
                               ? read_experiment(files.folder, nominal, reader_of(files, arms))
                               : state_of(files, nominal, reader_of(files, arms)));
}

Experiment bench_of(const StudyFiles& files) {
  const std::optional<NominalChain> model = model_of(files);
  const NominalChain* const nominal = model ? &*model : nullptr;
  if (files.folder.empty()) return read_plan(example_folder, example_file, nominal);
  exchange::ArmReader arms;
  return arms.with_effects(read_plan(files.folder, nominal, reader_of(files, arms)));
}

Study study_of(const Experiment& experiment, const std::filesystem::path& effects) {
  return study_with(
      decimated(with_probable_motion(experiment)),
      effects.empty() ? std::vector<StatedEffect>{} : read_effects(effects, experiment.covariates));
}

}  // namespace plumbline::diagnose
