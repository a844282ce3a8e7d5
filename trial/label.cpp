#include "trial/label.hpp"

#include <plumbline/base/error.hpp>

namespace plumbline::trial {
namespace {

/// Counted from 1; 0 where there is none, or null.
std::size_t joint_of(const nlohmann::json& effect) {
  const nlohmann::json joint = effect.value("joint", nlohmann::json());
  return joint.is_null() ? 0 : joint.get<std::size_t>();
}

TrueEffect effect_from(const nlohmann::json& json) {
  TrueEffect effect;
  effect.id = json.at("id");
  effect.joint = joint_of(json);
  if (json.contains("parameters"))
    for (const auto& [name, value] : json["parameters"].items()) effect.parameters.emplace_back(name, value);
  effect.strength = json.value("strength_sigma", 0.0);
  return effect;
}

}  // namespace

std::string effect_key(const std::string& id, std::size_t joint) {
  return joint > 0 ? id + "(" + std::to_string(joint) + ")" : id;
}

std::string effect_key(const nlohmann::json& effect) {
  return effect.is_string() ? effect.get<std::string>() : effect_key(effect.at("id"), joint_of(effect));
}

std::vector<std::string> effect_keys(const nlohmann::json& effects) {
  if (!effects.is_array()) return {effect_key(effects)};
  std::vector<std::string> keys;
  for (const nlohmann::json& effect : effects) keys.push_back(effect_key(effect));
  return keys;
}

bool outside_catalogue(const Label& label) {
  return label.effects.size() == 1 && label.effects.front().id == "unknown";
}

nlohmann::ordered_json as_json(const Label& label) {
  using Json = nlohmann::ordered_json;
  Json effects = Json::array();
  for (const TrueEffect& effect : label.effects) {
    Json parameters = Json::object();
    for (const auto& [name, value] : effect.parameters) parameters[name] = value;
    effects.push_back({{"id", effect.id},
                       {"joint", effect.joint > 0 ? Json(effect.joint) : Json(nullptr)},
                       {"parameters", parameters},
                       {"strength_sigma", effect.strength}});
  }
  return {{"name", label.name},
          {"effects", effects},
          {"equivalent", label.equivalent},
          {"strength_sigma", label.strength},
          {"noise", label.noise},
          {"noise_scale", label.noise_scale},
          {"description", label.description},
          {"channel", label.channel}};
}

Label label_from(const nlohmann::json& json, const std::string& source) {
  try {
    Label label;
    label.name = json.value("name", "");
    for (const auto& effect : json.at("effects")) label.effects.push_back(effect_from(effect));
    for (const auto& alternative : json.value("equivalent", nlohmann::json::array()))
      label.equivalent.push_back(effect_keys(alternative));
    label.strength = json.value("strength_sigma", 0.0);
    label.noise = json.value("noise", "");
    label.noise_scale = json.value("noise_scale", json.value("noise_factor", 1.0));
    label.description = json.value("description", "");
    label.channel = json.value("channel", "");
    return label;
  } catch (const nlohmann::json::exception& error) {
    throw Error(source, error.what(),
                "a label: an object with \"effects\", a list of objects with \"id\" and \"joint\"");
  }
}

}  // namespace plumbline::trial
