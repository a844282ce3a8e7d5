#include <fmt/core.h>

#include <memory>

#include "app/progress.hpp"
#include "app/verbs.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/exchange/toml.hpp"

namespace plumbline::app {
namespace {

exchange::PlanarChain chain_in(const std::string& file) {
  const Progress progress("chain", 0);
  return exchange::read_model(file);
}

void run(const std::string& file) {
  const exchange::PlanarChain read = chain_in(file);
  exchange::Model model{
      "The planar elastic chain of " + std::filesystem::path(file).filename().string(), {}, {}, {}};
  static_cast<diagnose::NominalChain&>(model.experiment) = read.chain;
  std::string notes;
  for (const std::string& note : read.notes) notes += "# " + note + "\n";
  fmt::print("{}{}", notes, exchange::to_toml(model).text);
}

}  // namespace

void add_chain(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("chain", "The planar elastic chain of a simulator's model, as our TOML");
  const auto file = std::make_shared<std::string>();
  verb->add_option("model", *file, "A model: .xml (MJCF), .urdf, .sdf, or .toml")
      ->type_name("FILE")
      ->required();
  verb->callback([file] { run(*file); });
}

}  // namespace plumbline::app
