#include "app/loaded_input.hpp"

#include <filesystem>

#include "app/chain_file.hpp"
#include "app/model_chain.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::app {

namespace {

const char* const table1_z =
    "lengths = [1, 1, 1, 1]\nstiffness = [1, 1, 1, 1]\nrest = [-0.2417, 0.6821, -0.7958, 0.5170]\n";

}  // namespace

void LoadedChain::add_to(CLI::App& verb) {
  verb.add_option(
          "chain", path,
          "CHAIN.toml with the lists lengths, stiffness and rest (the joint angles of the unloaded shape; a "
          "passive base joint begins at its own), or - for standard input. Without it: the four-link Z-chain "
          "of the paper's Table 1")
      ->type_name("FILE");
}

void LoadedChain::read() {
  if (path.empty()) {
    exact = parse_chain(table1_z, name);
    return;
  }
  const bool piped = files::is_standard_input(path);
  if (!piped && !names_chain_file(path) && !std::filesystem::is_directory(path))
    throw Error(path, "a name that ends otherwise", "CHAIN.toml, or a model: .xml (MJCF), .urdf, .sdf");
  exact = parse_chain(read_chain_text(path), files::source_name(path));
  name = piped ? "chain" : files::printable(std::filesystem::path(path).stem().string());
}

}  // namespace plumbline::app
