#include "app/model_chain.hpp"

#include "app/complaints.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "diagnose/exchange/toml.hpp"
#include "support/files/text_file.hpp"

namespace plumbline::app {
namespace {

bool is_model(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".xml" || ending == ".urdf" || ending == ".sdf";
}

}  // namespace

bool names_chain_file(const std::filesystem::path& path) {
  return path.extension() == ".toml" || is_model(path);
}

std::string read_chain_text(const std::filesystem::path& path) {
  std::string text;
  if (is_model(path)) {
    exchange::Model model{"", {}, {}, {}};
    diagnose::NominalChain& chain = model.experiment;
    chain = exchange::read_model(path).chain;
    if (!chain.plain())
      complain(files::source_name(path) +
               ": friction and corrections are left out, the chain has springs alone here");
    chain.effects.clear();
    chain.laws.clear();
    text = exchange::to_toml(model).text;
  } else {
    text = files::read_text(path);
  }
  if (text.find("\nlink_mass") != std::string::npos)
    complain(files::source_name(path) +
             ": link_mass and gravity are left out, the chain weighs nothing here");
  return text;
}

}  // namespace plumbline::app
