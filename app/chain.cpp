#include <fmt/core.h>

#include <memory>

#include "app/arguments.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/exchange/toml.hpp"

namespace plumbline::app {
namespace {

struct ChainOptions {
  std::string file;
  std::string joints;
};

exchange::PlanarChain chain_in(const ChainOptions& options) {
  const Progress progress("chain", 0);
  return exchange::read_model(options.file, names_in(options.joints));
}

void run(const ChainOptions& options) {
  const exchange::PlanarChain read = chain_in(options);
  exchange::Model model{
      "The planar elastic chain of " + std::filesystem::path(options.file).filename().string(), {}, {}, {}};
  static_cast<diagnose::NominalChain&>(model.experiment) = read.chain;
  std::string notes;
  for (const std::string& note : read.notes) notes += "# " + note + "\n";
  fmt::print("{}{}", notes, exchange::to_toml(model).text);
}

}  // namespace

void add_chain(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "chain", "The planar elastic chain of a simulator's model, as our TOML, which all other verbs read");
  const auto options = std::make_shared<ChainOptions>();
  verb->add_option("model", options->file, "A model: .xml (MJCF), .urdf, .sdf, or .toml")
      ->type_name("FILE")
      ->required();
  verb->add_option("--joints", options->joints,
                   "The joints that make the chain, by the names of the model, with commas between them; the "
                   "others are held where the model draws them. Without it: all")
      ->type_name("NAMES");
  verb->callback([options] { run(*options); });
}

}  // namespace plumbline::app
