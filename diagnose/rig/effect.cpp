#include "diagnose/rig/effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <plumbline/base/error.hpp>

#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {

const std::vector<Effect>& catalogue() {
  static const std::vector<Effect> all = [] {
    std::vector<Effect> rows;
    for (const auto& group : {joint_effects, joint_law_effects, friction_effects, command_effects,
                              link_effects, axis_effects, bench_effects, tool_effects, load_sensor_effects,
                              place_sensor_effects, sensor_effects, common_effects, run_effects})
      for (Effect& row : group()) rows.push_back(std::move(row));
    return rows;
  }();
  return all;
}

const std::map<std::string_view, std::string_view>& former_ids() {
  static const std::map<std::string_view, std::string_view> all{{"joint_zero", "rest_angle"},
                                                                {"zero_spread", "rest_spread"},
                                                                {"axis_spread", "length_spread"},
                                                                {"link_flexibility", "link_bending"},
                                                                {"tool_mass", "tip_payload"},
                                                                {"load_offset", "eccentric_load"},
                                                                {"mount_compliance", "base_compliance"},
                                                                {"tracker_offset", "position_offset"},
                                                                {"tracker_turn", "camera_turn"},
                                                                {"tracker_scale", "camera_scale"},
                                                                {"wrench_bias", "force_bias"},
                                                                {"load_zero", "force_bias"},
                                                                {"wrench_scale", "force_gain"},
                                                                {"load_gain", "force_gain"},
                                                                {"load_drift", "sensor_drift"},
                                                                {"load_lag", "sensor_lag"}};
  return all;
}

std::string_view current_id(std::string_view id) {
  const auto found = former_ids().find(id);
  return found == former_ids().end() ? id : found->second;
}

const Effect& effect(std::string_view id, std::size_t joint) {
  const auto fit = [&](const Effect& row) { return 2 * (row.at_joint == (joint > 0)) + row.form.empty(); };
  const Effect* named = nullptr;
  for (const Effect& row : catalogue())
    if (row.id == current_id(id) && (named == nullptr || fit(row) > fit(*named))) named = &row;
  if (named != nullptr) return *named;
  throw Error("effect", std::string(id), "an id of the effect catalogue");
}

std::string EffectAt::label() const {
  std::string text(effect->id);
  return joint > 0 ? text + "(" + std::to_string(joint) + ")" : text;
}

std::string EffectAt::name() const {
  return effect->form.empty() ? label() : fmt::format("{} ({})", label(), effect->form);
}

std::string EffectAt::in_words() const {
  return fmt::format(fmt::runtime(effect->words), joint);
}

std::string Candidate::label() const {
  std::string text;
  for (const EffectAt& at : effects) text += (text.empty() ? "" : " + ") + at.label();
  return text;
}

std::string Candidate::name() const {
  std::string text;
  for (const EffectAt& at : effects) text += (text.empty() ? "" : " + ") + at.name();
  return text;
}

bool Candidate::has(const EffectAt& at) const {
  return std::find(effects.begin(), effects.end(), at) != effects.end();
}

bool Candidate::is_form_of(const Candidate& other) const {
  return std::is_permutation(effects.begin(), effects.end(), other.effects.begin(), other.effects.end(),
                             [](const EffectAt& a, const EffectAt& b) {
                               return a.effect->id == b.effect->id && a.joint == b.joint;
                             });
}

bool Candidate::is_part_of(const Candidate& other) const {
  return effects.size() < other.effects.size() &&
         std::all_of(effects.begin(), effects.end(), [&](const EffectAt& at) { return other.has(at); });
}

bool Candidate::has_all_tolerances() const {
  return std::all_of(catalogue().begin(), catalogue().end(),
                     [&](const Effect& row) { return !row.is_tolerance || has(EffectAt(row)); });
}

bool Candidate::has_as_tolerance(const EffectAt& at) const {
  return at.effect->is_tolerance && has_all_tolerances();
}

std::size_t Candidate::count() const {
  if (!has_all_tolerances()) return effects.size();
  return 1 + static_cast<std::size_t>(std::count_if(effects.begin(), effects.end(), [](const EffectAt& at) {
           return !at.effect->is_tolerance;
         }));
}

}  // namespace plumbline::diagnose
