#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "trial/simulator/bench.hpp"

namespace plumbline::simulator {
namespace {

/// Whether another effect gives the same readings, to the noise.
bool passes_for(const Bench& bench, const Outcome& outcome, std::size_t e, const Effect& other) {
  constexpr double noticed = 2;  // standard deviations of all readings together
  std::vector<Effect> effects = outcome.effects;
  effects[e] = other;
  const std::vector<Excess> rest =
      gap(bench.plan, outcome.shown, outcome_of(bench, effects).shown, bench.scatter.sigma);
  return rms(rest) * std::sqrt(static_cast<double>(rest.size())) <= noticed;
}

/// The effect of a single joint that may be equivalent to this one of all joints.
std::string_view of_one_joint(const Kind& kind) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> pairs{
      {{"joint_stops", "joint_stop"},
       {"piecewise_spring", "piecewise_spring"},
       {"stiffness_scale", "joint_stiffness"},
       {"force_gain", "joint_stiffness"},
       {"length_scale", "link_length"},
       {"rest_offset", "rest_angle"}}};
  const auto known =
      std::find_if(pairs.begin(), pairs.end(), [&](const auto& one) { return one.first == kind.id; });
  return kind.at_joint || known == pairs.end() ? std::string_view() : known->second;
}

/// Links of a larger total weight: by weight per length, or by a factor.
std::optional<Effect> as_other_weight(const Nominal& nominal, const Effect& effect) {
  const double mass = std::accumulate(nominal.mass.begin(), nominal.mass.end(), 0.0),
               length = std::accumulate(nominal.length.begin(), nominal.length.end(), 0.0);
  if (!(mass > 0)) return std::nullopt;
  if (effect.kind->id == "gravity")
    return Effect{&kind("mass_scale", false), 0, {effect.values[0] * length / mass}};
  if (effect.kind->id == "mass_scale" && effect.values[0] > 0)
    return Effect{&kind("gravity", false), 0, {effect.values[0] * mass / length}};
  return std::nullopt;
}

/// Aliases of joint laws: all stops, or softening springs, and the one that is reached; effects of all joints
/// and of a single sprung one, and then the gain of the load cell; asymmetric springs and a stiffness scale
/// where all joints deflect in one direction; the two weights of links.
std::vector<std::string> tried(const Bench& bench, const Outcome& outcome, std::size_t e) {
  const Effect& effect = outcome.effects[e];
  std::vector<Effect> candidates;
  const std::vector<double>& k = bench.plan.nominal.stiffness;
  const bool one_joint = std::count_if(k.begin(), k.end(), [](double one) { return one > 0; }) == 1;
  const std::string_view single = of_one_joint(*effect.kind);
  const bool own_stops = effect.kind->id == "joint_stops" && !effect.kind->each.empty();
  const bool sets_in = effect.kind->id == "joint_stops" || effect.kind->id == "piecewise_spring";
  if (!single.empty() && (sets_in || one_joint))
    for (Place j = 0; j < bench.plan.size(); ++j)
      candidates.push_back({&kind(single, true), j,
                            own_stops ? Values{effect.values[1 + j], effect.values[0]} : effect.values});
  if (effect.kind->id == "asymmetric_spring" && effect.kind->each.empty())
    for (const double sign : {1.0, -1.0})
      candidates.push_back({&kind("stiffness_scale", false), 0, {sign * effect.values[0]}});
  if (const std::optional<Effect> weight = as_other_weight(bench.plan.nominal, effect))
    candidates.push_back(*weight);
  std::vector<std::string> aliases;
  for (const Effect& candidate : candidates)
    if (passes_for(bench, outcome, e, candidate)) aliases.push_back(key_of(candidate));
  return aliases;
}

/// Aliases of one effect: payload and tare, always; compliance of base and train along x under an imposed end
/// point; a stiffness scale and the gain where nothing else sets a force.
std::vector<std::string> aliases_of(const Bench& bench, const Outcome& outcome, std::size_t e) {
  const bool imposed = std::none_of(bench.plan.runs.begin(), bench.plan.runs.end(),
                                    [](const PlannedRun& run) { return run.force_controlled; });
  const bool scales = imposed && outcome.effects.size() == 1 && bench.plan.nominal.mass.empty();
  const std::string_view id = outcome.effects[e].kind->id;
  if (id == "tip_payload") return {"force_bias"};
  if (id == "train_compliance" && imposed) return {"base_compliance"};
  const Effect& effect = outcome.effects[e];
  if (id == "base_compliance" && imposed &&
      passes_for(bench, outcome, e, {effect.kind, 0, {effect.values[0], 0}}))
    return {"train_compliance"};
  std::vector<std::string> others = tried(bench, outcome, e);
  if (id == "asymmetric_spring" && !others.empty() && scales) others.emplace_back("force_gain");
  if (id == "stiffness_scale" && scales) others.emplace_back("force_gain");
  if (id == "force_gain" && scales) others.emplace_back("stiffness_scale");
  return others;
}

}  // namespace

std::vector<std::vector<std::string>> aliases(const Bench& bench, const Outcome& outcome) {
  std::vector<std::vector<std::string>> all;
  for (std::size_t e = 0; e < outcome.effects.size(); ++e) {
    for (const std::string& alias : aliases_of(bench, outcome, e)) {
      all.emplace_back();
      for (std::size_t k = 0; k < outcome.effects.size(); ++k)
        all.back().push_back(k == e ? alias : key_of(outcome.effects[k]));
    }
  }
  return all;
}

}  // namespace plumbline::simulator
