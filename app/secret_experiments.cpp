#include "app/secret_experiments.hpp"

#include <fmt/core.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <plumbline/error.hpp>
#include <thread>

#include "files/text_file.hpp"
#ifdef PLUMBLINE_RIG
#include "rig/write_experiment.hpp"
#endif

namespace plumbline {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

#ifdef PLUMBLINE_RIG
SecretExperiments made(std::size_t trials, std::uint64_t seed, const fs::path& folder, unsigned threads,
                       const std::function<void()>& advance) {
  SecretExperiments secret;
  std::mutex writing;
  std::exception_ptr failure;
  std::atomic<std::size_t> next = 1;
  const auto work = [&] {
    try {
      for (std::size_t number = next++; number <= trials; number = next++) {
        const std::string name = fmt::format("trial-{:03}", number);
        const rig::Experiment experiment = rig::make_experiment(seed, number, name);
        rig::write_experiment(experiment, folder / name);
        const std::scoped_lock lock(writing);
        secret.envelopes[name] = trial::envelope(experiment.label);
        if (!std::isnan(experiment.nominal_error)) secret.nominal_errors.push_back(experiment.nominal_error);
        advance();
      }
    } catch (...) {
      const std::scoped_lock lock(writing);
      failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned t = 0; t < threads; ++t) workers.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
  return secret;
}
#else
SecretExperiments made(std::size_t, std::uint64_t, const fs::path&, unsigned, const std::function<void()>&) {
  throw Error("trial --trials", "a program built without the rig",
              "one built with -DPLUMBLINE_RIG=ON, or --experiments DIR");
}
#endif

}  // namespace

SecretExperiments make_experiments(std::size_t trials, std::uint64_t seed, const fs::path& folder,
                                   unsigned threads, const std::function<void()>& advance) {
  SecretExperiments secret = made(trials, seed, folder, threads, advance);
  trial::Seals seals;
  for (const auto& [name, envelope] : secret.envelopes) seals[name] = trial::seal(envelope);
  write(folder / "seals.json", trial::seals_text(seals));
  return secret;
}

void publish(const SecretExperiments& secret, const fs::path& folder) {
  fs::create_directories(folder / "labels");
  for (const auto& [name, envelope] : secret.envelopes)
    write(folder / "labels" / (name + ".json"), trial::envelope_text(envelope));
}

}  // namespace plumbline
