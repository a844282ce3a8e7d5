#include <fmt/core.h>

#include <memory>

#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "diagnose/exchange/arm_toml.hpp"
#include "diagnose/exchange/read_model.hpp"

namespace plumbline::app {
namespace {

struct ArmOptions {
  std::string file;
  exchange::ArmEnds ends;
};

exchange::SpatialArm arm_in(const ArmOptions& options) {
  const Progress progress("arm", 0);
  return exchange::read_arm(options.file, options.ends);
}

void run(const ArmOptions& options) {
  const exchange::SpatialArm read = arm_in(options);
  std::string notes = fmt::format("# base: {}; tip: {}\n", read.nominal.base, read.nominal.tip);
  for (const std::string& note : read.notes) notes += "# " + note + "\n";
  fmt::print("{}# The arm of {}\n\n{}", notes, std::filesystem::path(options.file).filename().string(),
             exchange::arm_toml(read.nominal));
}

}  // namespace

void add_arm(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "arm",
      "The arm in space of a simulator's model: joints, axes, masses, gains, as an experiment has them");
  const auto options = std::make_shared<ArmOptions>();
  verb->add_option("model", options->file, "A model: .xml (MJCF), .urdf or .sdf")
      ->type_name("FILE")
      ->required();
  verb->add_option("--base", options->ends.base,
                   "The body at the base of the arm. Without it: the root of the tip")
      ->type_name("NAME");
  verb->add_option("--tip", options->ends.tip,
                   "The body or frame at the tip. Without it: what is named as a tip, or the last body")
      ->type_name("NAME");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
