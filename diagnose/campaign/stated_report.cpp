#include "diagnose/campaign/stated_report.hpp"

#include <algorithm>

namespace plumbline::campaign {
namespace {

using files::JsonValue;

/// Counted from 1; 0 where there is none, or null.
std::size_t joint_of(const JsonValue& effect) {
  constexpr std::size_t most = 1000000;
  if (!effect.has("joint")) return 0;
  const JsonValue joint = effect.at("joint", "");
  const bool whole = joint.json().is_number_unsigned();
  if (!whole || joint.json().get<std::size_t>() < 1 || joint.json().get<std::size_t>() > most)
    joint.refuse("the number of a joint, counted from 1, or null");
  return joint.json().get<std::size_t>();
}

std::string id_of(const JsonValue& effect) {
  return effect.at("id", "an effect of the catalogue, or \"unknown\"").text("the name of an effect");
}

std::string key_of(const JsonValue& effect) {
  return effect.json().is_string() ? effect.text("") : effect_name(effect).key();
}

const char* const expected = "a report in the format \"gap-diagnosis/2\"";

JsonValue at(const JsonValue& object, const char* key) {
  return object.at(key, expected);
}

double number(const JsonValue& object, const char* key) {
  return at(object, key).number(expected);
}

/// The entry of a list with the largest share.
std::optional<JsonValue> largest(const JsonValue& list) {
  std::optional<JsonValue> best;
  for (const JsonValue& one : list.list(expected))
    if (!best || number(one, "share") > number(*best, "share")) best = one;
  return best;
}

void read_bounds(const JsonValue& effect, const std::string& key, StatedReport& report) {
  for (const auto& [name, value] : at(effect, "parameters").members(expected)) {
    if (!at(value, "low").json().is_number() || !at(value, "high").json().is_number()) continue;
    const auto [low, high] = std::minmax({number(value, "low"), number(value, "high")});
    report.bounds[parameter_key(key, name)] = {low, high, number(value, "value"),
                                               value.text_or("unit", "ratio")};
  }
}

void read_cause(const JsonValue& cause, StatedReport& report) {
  report.verdict = at(cause, "verdict").text(expected);
  for (const JsonValue& effect : at(cause, "effects").list(expected)) {
    report.effects.push_back(key_of(effect));
    read_bounds(effect, report.effects.back(), report);
  }
  for (const JsonValue& alternative : at(cause, "equivalent").list(expected))
    report.equivalent.push_back(effect_keys(alternative));
  for (const JsonValue& one : at(cause, "ranking").list(expected))
    report.ranking.push_back({effect_keys(at(one, "effects")), number(one, "probability")});
}

}  // namespace

std::string parameter_key(const std::string& effect, const std::string& name) {
  return effect + "/" + name;
}

std::string EffectName::key() const {
  return joint > 0 ? id + "(" + std::to_string(joint) + ")" : id;
}

EffectName effect_name(const JsonValue& effect) {
  return {id_of(effect), joint_of(effect)};
}

std::vector<std::string> effect_keys(const JsonValue& effects) {
  if (!effects.json().is_array()) return {key_of(effects)};
  std::vector<std::string> keys;
  for (const JsonValue& effect : effects.list("")) keys.push_back(key_of(effect));
  return keys;
}

StatedReport report_from(const nlohmann::json& json, const std::string& source) {
  const JsonValue file(json, source);
  StatedReport report;
  read_cause(at(file, "cause"), report);
  const JsonValue where = at(file, "where");
  if (const auto joint = largest(at(where, "joints")))
    report.joint = static_cast<std::size_t>(number(*joint, "joint"));
  if (const auto channel = largest(at(where, "channels")))
    report.channel = at(*channel, "channel").text(expected);
  if (const JsonValue shrink = at(file, "shrink"); shrink.json().is_object()) {
    const double floor = shrink.number_or("noise_floor_ratio", 0.0);
    if (floor > 0) report.shrunk = number(shrink, "ratio") / floor;
  }
  if (file.has("against")) report.sense = at(at(file, "against"), "sense").text(expected);
  return report;
}

}  // namespace plumbline::campaign
