#include "exchange/toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "exchange/carried.hpp"

namespace plumbline::exchange {
namespace {

bool any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double v) { return v != 0; });
}

std::string list(const char* key, const std::vector<double>& values) {
  return fmt::format("{} = [{}]\n", key, fmt::join(values, ", "));
}

std::string effect_table(const diagnose::NominalEffect& effect) {
  std::string text = fmt::format("\n[[nominal.effect]]\nid = \"{}\"\n", effect.id), parameters;
  if (effect.joint > 0) text += fmt::format("joint = {}\n", effect.joint);
  for (const auto& [name, value] : effect.parameters)
    parameters += fmt::format("{}{} = {}", parameters.empty() ? "" : ", ", name, value);
  return text + "parameters = { " + parameters + " }\n";
}

}  // namespace

Written to_toml(const Model& model) {
  const diagnose::NominalChain& chain = model.experiment;
  Written file;
  for (const diagnose::NominalEffect& effect : chain.effects)
    file.effects.push_back({effect.label(), true,
                            of_catalogue(effect) ? "as [[nominal.effect]]"
                                                 : "as [[nominal.effect]], to be read with --effects again"});
  if (!model.laws.empty())
    file.effects.push_back({"torque_law", false, "a nominal chain has no free torque law: the table below"});
  for (const std::string& line : head_lines(model, file.effects)) file.text += "# " + line + "\n";
  file.text += "\n[nominal]\n" + list("link_length", chain.link_length) +
               list("joint_stiffness", chain.joint_stiffness);
  if (any(chain.link_mass)) file.text += list("link_mass", chain.link_mass);
  if (chain.gravity != std::array<double, 2>{0, 0})
    file.text += list("gravity", {chain.gravity.begin(), chain.gravity.end()});
  if (!chain.rest.empty()) file.text += list("rest", chain.rest);
  for (const diagnose::NominalEffect& effect : chain.effects) file.text += effect_table(effect);
  return file;
}

}  // namespace plumbline::exchange
