#include "trial/label.hpp"

#include <plumbline/error.hpp>

namespace plumbline::trial {
namespace {

/// An alternative is a list of effects, each a name or an object with id and joint.
std::vector<std::string> names(const nlohmann::json& alternative) {
  const auto name = [](const nlohmann::json& one) {
    if (one.is_string()) return one.get<std::string>();
    const nlohmann::json joint = one.value("joint", nlohmann::json());
    return effect_key(one.at("id"), joint.is_number() ? joint.get<std::size_t>() : 0);
  };
  if (!alternative.is_array()) return {name(alternative)};
  std::vector<std::string> all;
  for (const auto& one : alternative) all.push_back(name(one));
  return all;
}

TrueEffect effect_from(const nlohmann::json& json) {
  TrueEffect effect;
  effect.id = json.at("id");
  if (json.contains("joint") && !json["joint"].is_null()) effect.joint = json["joint"];
  if (json.contains("parameters"))
    for (const auto& [name, value] : json["parameters"].items()) effect.parameters.emplace_back(name, value);
  effect.strength = json.value("strength_sigma", 0.0);
  return effect;
}

}  // namespace

std::string effect_key(const std::string& id, std::size_t joint) {
  return joint > 0 ? id + "(" + std::to_string(joint) + ")" : id;
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
      label.equivalent.push_back(names(alternative));
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
