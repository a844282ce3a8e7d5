#include "app/secret_experiments.hpp"

#include <fmt/core.h>

#include <cmath>
#include <mutex>
#include <plumbline/base/error.hpp>
#include <plumbline/base/parallel.hpp>

#include "files/output_file.hpp"
#ifdef PLUMBLINE_SIMULATOR
#include "simulator/write_experiment.hpp"
#endif

namespace plumbline::app {
namespace {

namespace fs = std::filesystem;

#ifdef PLUMBLINE_SIMULATOR
SecretExperiments made(BlindTrial which, std::size_t trials, std::uint64_t seed, const fs::path& folder,
                       unsigned threads, const std::function<void()>& advance) {
  const auto from = which == BlindTrial::first ? simulator::Trial::first : simulator::Trial::second;
  SecretExperiments secret;
  std::mutex writing;
  in_parallel(trials, threads, [&](std::size_t i) {
    const std::string name = fmt::format("trial-{:03}", i + 1);
    const simulator::Experiment experiment = simulator::make_experiment(from, seed, i + 1, name);
    simulator::write_experiment(experiment, folder / name);
    const std::scoped_lock lock(writing);
    secret.envelopes[name] = trial::envelope(experiment.label);
    if (!std::isnan(experiment.nominal_error)) secret.nominal_errors.push_back(experiment.nominal_error);
    advance();
  });
  return secret;
}
#else
SecretExperiments made(BlindTrial, std::size_t, std::uint64_t, const fs::path&, unsigned,
                       const std::function<void()>&) {
  throw Error("trial --trials", "a program built without the rig",
              "one built with -DPLUMBLINE_SIMULATOR=ON, or --experiments DIR");
}
#endif

}  // namespace

SecretExperiments make_experiments(BlindTrial which, std::size_t trials, std::uint64_t seed,
                                   const fs::path& folder, unsigned threads,
                                   const std::function<void()>& advance) {
  SecretExperiments secret = made(which, trials, seed, folder, threads, advance);
  trial::Seals seals;
  for (const auto& [name, envelope] : secret.envelopes) seals[name] = trial::seal(envelope);
  files::write_text(folder / "seals.json", trial::seals_text(seals));
  return secret;
}

void publish(const SecretExperiments& secret, const fs::path& folder) {
  fs::create_directories(folder / "labels");
  for (const auto& [name, envelope] : secret.envelopes)
    files::write_text(folder / "labels" / (name + ".json"), trial::envelope_text(envelope));
}

}  // namespace plumbline::app
