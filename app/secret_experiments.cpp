#include "app/secret_experiments.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <plumbline/base/error.hpp>

#include "support/files/output_file.hpp"
#include "support/files/printable.hpp"
#ifdef PLUMBLINE_SIMULATOR
#include "trial/simulator/write_experiment.hpp"
#endif

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* word(BlindTrial which) {
  return which == BlindTrial::first ? "first" : "second";
}

std::string name_of(std::size_t number) {
  return fmt::format("trial-{:03}", number);
}

/// The label, as text, is what is sealed.
#ifdef PLUMBLINE_SIMULATOR
std::string make(const std::string& item) {
  const Json told = Json::parse(item);
  const auto from =
      told["trial"] == word(BlindTrial::first) ? simulator::Trial::first : simulator::Trial::second;
  const std::string name = name_of(told["number"]);
  const simulator::Experiment experiment =
      simulator::make_experiment(from, told["seed"], told["number"], name);
  simulator::write_experiment(experiment, fs::path(std::string(told["folder"])) / name);
  return Json{{"label", trial::as_json(experiment.label).dump()}, {"nominal_error", experiment.nominal_error}}
      .dump();
}
#else
std::string make(const std::string&) {
  throw Error("trial --trials", "a program built without the rig",
              "one built with -DPLUMBLINE_SIMULATOR=ON, or --experiments DIR");
}
#endif

/// The seed determines the experiments and their labels, so the salts may depend on it.
std::string secret_of(BlindTrial which, std::uint64_t seed) {
  return fmt::format("plumbline {} trial {}", word(which), seed);
}

}  // namespace

const work::Task experiment_task{"experiment", make};

SecretExperiments make_experiments(BlindTrial which, std::size_t trials, std::uint64_t seed,
                                   const fs::path& folder, const std::function<void()>& advance) {
  work::WorkList list{experiment_task, {}};
  for (std::size_t number = 1; number <= trials; ++number)
    list.items.push_back(
        Json{{"trial", word(which)}, {"seed", seed}, {"number", number}, {"folder", files::text_of(folder)}}
            .dump());
  SecretExperiments secret;
  trial::Seals seals;
  std::size_t number = 0;
  for (const std::string& result : work::results(list, nullptr, advance)) {
    const Json made = Json::parse(result);
    const std::string name = name_of(++number);
    const trial::Envelope envelope{trial::salt(secret_of(which, seed), name), made["label"]};
    seals[name] = trial::seal(envelope);
    secret.envelopes[name] = envelope;
    if (!made["nominal_error"].is_null())
      secret.nominal_errors.push_back(made["nominal_error"]);  // NaN is null
  }
  files::write_text(folder / "seals.json", trial::seals_text(seals));
  return secret;
}

void publish(const SecretExperiments& secret, const fs::path& folder) {
  fs::create_directories(folder / "labels");
  for (const auto& [name, envelope] : secret.envelopes)
    files::write_text(folder / "labels" / (name + ".json"), trial::envelope_text(envelope));
}

}  // namespace plumbline::app
