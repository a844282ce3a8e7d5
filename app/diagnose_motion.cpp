#include "app/diagnose_motion.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "diagnose/motion/read_bench.hpp"
#include "diagnose/motion/report.hpp"

namespace plumbline::app {

bool is_motion(const std::string& folder) {
  return !folder.empty() &&
         std::filesystem::is_regular_file(std::filesystem::path(folder) / "experiment.toml") &&
         motion::is_motion(folder);
}

void diagnose_motion(const std::string& folder, const std::string& json, const CLI::App& verb) {
  Outputs outputs(verb, {std::filesystem::path(folder) / "experiment.toml"});
  files::OutputFile* const file = outputs.open("--json", json);
  const motion::Study study(motion::read_bench(folder));
  constexpr std::size_t steps = 100;
  Progress progress("diagnosis", steps);
  std::size_t shown = 0;
  const motion::Diagnosis diagnosis = motion::diagnose_motion(study, [&](double share) {
    for (; shown < static_cast<std::size_t>(share * steps); ++shown) progress.advance();
  });
  if (file) file->write(page::json_text(as_json(diagnosis), outputs.provenance()));
  outputs.commit();
  if (json != "-") fmt::print("{}", as_text(diagnosis));
}

}  // namespace plumbline::app
