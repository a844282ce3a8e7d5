#include "app/loaded_input.hpp"

#include <filesystem>

#include "app/case_words.hpp"
#include "app/model_chain.hpp"
#include "statement/chain_file.hpp"
#include "support/files/printable.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::app {

namespace {

const char* const table1_z =
    "lengths = [1, 1, 1, 1]\nstiffness = [1, 1, 1, 1]\nrest = [-0.2417, 0.6821, -0.7958, 0.5170]\n";

NamedModel model_of(const std::string& name, const SpaceStructure<Rational>& structure) {
  return {name, case_of(structure), bent_structure(from_rational<double>(structure)),
          bent_structure(from_rational<Mpfr50>(structure))};
}
NamedModel model_of(const std::string& name, const statement::PlaneChain& chain) {
  return {name, case_of(chain.structure), bent_structure(from_rational<double>(chain.structure)),
          bent_structure(from_rational<Mpfr50>(chain.structure))};
}

}  // namespace

void LoadedChain::add_to(CLI::App& verb) {
  verb.add_option(
          "chain", path,
          "CHAIN.toml with the lists lengths, stiffness and rest (the joint angles of the unloaded shape; a "
          "passive base joint begins at its own), and ends and loads, or joints in space, where they are not "
          "the paper's; or - for standard input, or a simulator's model (.xml, .urdf, .sdf). Without it: the "
          "four-link Z-chain of the paper's Table 1")
      ->type_name("FILE");
}

void LoadedChain::read() {
  if (path.empty()) return take(statement::parse_plane_chain(table1_z, name), name);
  const bool piped = files::is_standard_input(path);
  if (!piped && !names_chain_file(path) && !std::filesystem::is_directory(path))
    throw Error(path, "a name that ends otherwise", "CHAIN.toml, or a model: .xml (MJCF), .urdf, .sdf");
  const std::string text = read_chain_text(path), source = files::source_name(path);
  name = piped ? "chain" : files::printable(std::filesystem::path(path).stem().string());
  take(statement::parse_chain(text, source), source);
}

void LoadedChain::take(const statement::StatedChain& read, const std::string& source) {
  const auto* plane = std::get_if<statement::PlaneChain>(&read);
  plain = plane != nullptr && plane->plain;
  if (plane != nullptr) {
    exact = plane->structure.chain;
    structure = plane->structure;
  }
  try {
    model = std::visit([&](const auto& chain) { return model_of(name, chain); }, read);
  } catch (const Error& error) {
    throw Error(source + ": " + error.what());
  }
}

}  // namespace plumbline::app
