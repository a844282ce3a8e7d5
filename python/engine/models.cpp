#include "diagnose/draft/draft.hpp"
#include "diagnose/exchange/read_model.hpp"
#include "python/engine/engine.hpp"

namespace plumbline::python {
namespace {

using Texts = std::vector<std::pair<std::string, std::string>>;  ///< by name

py::dict chain_of(const std::string& file, const std::vector<std::string>& joints) {
  const exchange::PlanarChain read = unlocked([&] { return exchange::read_model(file, joints); });
  py::dict chain;
  chain["link_length"] = array_of(read.chain.link_length);
  chain["joint_stiffness"] = array_of(read.chain.joint_stiffness);
  chain["link_mass"] = array_of(read.chain.link_mass);
  chain["gravity"] = array_of({read.chain.gravity.begin(), read.chain.gravity.end()});
  chain["rest"] = array_of(read.chain.rest);
  chain["joints"] = read.names;
  chain["notes"] = read.notes;
  return chain;
}

py::dict draft_of(const std::string& name, const std::string& file, const std::vector<std::string>& joints,
                  const Texts& tables) {
  const auto draft = unlocked([&] {
    const exchange::PlanarChain read = exchange::read_model(file, joints);
    const Eigen::Vector2d base = read.plane.of(read.plane.origin);
    std::vector<diagnose::DraftFile> given;
    for (const auto& [title, text] : tables) given.push_back({title, text});
    return diagnose::draft_experiment(name, {read.chain, read.names, {base.x(), base.y()}, read.weighs},
                                      given);
  });
  py::list guesses;
  for (const diagnose::Guess& one : draft.guesses)
    guesses.append(py::make_tuple(one.what, one.value, one.reason, one.doubtful));
  py::dict files;
  for (const diagnose::DraftFile& table : draft.tables) files[py::str(table.name)] = table.text;
  py::dict result;
  result["settings"] = draft.settings, result["tables"] = files;
  result["guesses"] = guesses, result["question"] = draft.question;
  return result;
}

}  // namespace

void add_models(py::module_& module) {
  using namespace py::literals;
  module.def("chain", &chain_of, "file"_a, "joints"_a);
  module.def("draft", &draft_of, "name"_a, "model"_a, "joints"_a, "tables"_a);
}

}  // namespace plumbline::python
