#include "trial/label.hpp"

#include "diagnose/campaign/stated_report.hpp"

namespace plumbline::trial {
namespace {

TrueEffect effect_from(const files::JsonValue& json) {
  const campaign::EffectName named = campaign::effect_name(json);
  TrueEffect effect{named.id, named.joint, {}};
  if (json.has("parameters"))
    for (const auto& [parameter, value] : json.at("parameters", "").members("parameters by name"))
      effect.parameters.emplace_back(parameter, value.number("a number"));
  effect.strength = json.number_or("strength_sigma", 0.0);
  return effect;
}

}  // namespace

std::string effect_key(const std::string& id, std::size_t joint) {
  return campaign::EffectName{id, joint}.key();
}

bool outside_catalogue(const Label& label) {
  return label.effects.size() == 1 && label.effects.front().id == "unknown";
}

namespace {

/// "id(joint)" by its present id.
std::string present(const Catalogue& catalogue, const std::string& key) {
  const std::size_t end = key.find('(');
  const auto found = catalogue.find(key.substr(0, end));
  return found == catalogue.end() ? key : found->second + key.substr(std::min(end, key.size()));
}

}  // namespace

Label in_terms_of(const Catalogue& catalogue, Label label) {
  for (TrueEffect& effect : label.effects)
    if (const auto found = catalogue.find(effect.id); found != catalogue.end()) effect.id = found->second;
  for (std::vector<std::string>& alternative : label.equivalent)
    for (std::string& key : alternative) key = present(catalogue, key);
  std::string lacking;
  for (const TrueEffect& effect : label.effects) {
    const bool at_all = effect.id == "unknown" || (effect.joint == 0 && catalogue.count(effect.id) > 0);
    if (!at_all && catalogue.count(effect.id + "(j)") == 0)
      lacking += (lacking.empty() ? "" : ", ") + effect.id;
  }
  if (lacking.empty()) return label;
  label.description = lacking + (label.description.empty() ? "" : ": " + label.description);
  const std::size_t joint = label.effects.size() == 1 ? label.effects.front().joint : 0;
  label.effects = {{"unknown", joint, {}, label.strength}};
  label.equivalent.clear();
  return label;
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
          {"family", label.family},
          {"noise", label.noise},
          {"noise_scale", label.noise_scale},
          {"description", label.description},
          {"channel", label.channel}};
}

Label label_from(const nlohmann::json& json, const std::string& source) {
  const files::JsonValue file(json, source);
  const std::string effects = "a list \"effects\" of objects with \"id\" and \"joint\"";
  Label label;
  label.name = file.text_or("name", "");
  for (const auto& effect : file.at("effects", effects).list(effects))
    label.effects.push_back(effect_from(effect));
  if (file.has("equivalent"))
    for (const auto& alternative : file.at("equivalent", "").list("a list of explanations"))
      label.equivalent.push_back(campaign::effect_keys(alternative));
  label.strength = file.number_or("strength_sigma", 0.0);
  label.noise = file.text_or("noise", "");
  label.noise_scale = file.number_or("noise_scale", file.number_or("noise_factor", 1.0));
  label.description = file.text_or("description", "");
  label.family = file.text_or("family", "");
  label.channel = file.text_or("channel", "");
  return label;
}

}  // namespace plumbline::trial
