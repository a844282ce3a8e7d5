#include "diagnose/exchange/carried.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnose/exchange/ways.hpp"
#include "diagnose/rig/effect.hpp"
#include "diagnose/rig/load_cell.hpp"
#include "diagnose/rig/nominal.hpp"

namespace plumbline::exchange {

using diagnose::NominalEffect, diagnose::Rig, diagnose::Vector2;

Rig rig_with(const Model& model, const std::vector<NominalEffect>& effects) {
  diagnose::Experiment part = model.experiment;
  part.effects = effects;
  part.laws.clear();
  part.run_count = part.runs.size();
  return diagnose::nominal_rig(part);
}

namespace {

bool plays(const Rig& rig) {
  return std::any_of(rig.backlash.begin(), rig.backlash.end(), [](double b) { return b > 0; });
}

/// Whether all that weighs is pulled the same way, as one gravity does.
bool one_gravity(const Rig& rig) {
  Vector2 total = rig.payload;
  for (const Vector2& weight : rig.weight) total += weight;
  const double rounding = 1e-9 * total.norm();
  const auto along = [&](const Vector2& weight) {
    return weight.norm() * total.norm() - weight.dot(total) <= rounding * total.norm();
  };
  return along(rig.payload) && std::all_of(rig.weight.begin(), rig.weight.end(), along);
}

/// Whether every spring still pulls back after what neighbours share is taken off it.
bool springs_left(const Rig& rig) {
  const std::size_t n = rig.length.size();
  for (std::size_t j = 0; j < n; ++j) {
    const double neighbours = (j > 0 ? 1 : 0) + (j + 1 < n ? 1 : 0);
    if (rig.stiffness[j] * (1 - std::abs(rig.asymmetry[j])) < neighbours * std::abs(rig.coupling))
      return false;
  }
  return true;
}

/// Whether a spring that hardens is stiffer to one side: what follows its fourth power is the same to both.
bool hardens_to_one_side(const Rig& rig) {
  for (std::size_t j = 0; j < rig.length.size(); ++j)
    if (rig.hardening[j] != 0 && rig.asymmetry[j] != 0) return true;
  return false;
}

/// What stands against an effect beside those that are carried already; nothing where it goes.
std::string_view against(Format format, const NominalEffect& effect, const Rig& rig) {
  if (adds_weight(effect.id) && !one_gravity(rig)) return "weights in several directions";
  if (format == Format::mjcf && rig.eccentricity != 0 && has_drive(rig))
    return "the drive of this file holds the point where the load acts, not the end point";
  if (format == Format::mjcf && hardens_to_one_side(rig))
    return "a spring that hardens is as stiff to both sides in this file";
  if (response_of_cell(rig).lag > 0 && !rig.force_drift.isZero(0))
    return "what drifts does not lag in this file";
  if (rig.coupling != 0 && (!springs_left(rig) || plays(rig)))
    return "springs that neighbours share leave a joint without one of its own";
  if (format == Format::mjcf || !plays(rig)) return "";
  if (std::any_of(rig.stop.begin(), rig.stop.end(), [](double s) { return std::isfinite(s); }))
    return "a joint with play has no stop in this format";
  if (std::any_of(rig.friction.begin(), rig.friction.end(), [](double f) { return f > 0; }))
    return "a joint with play has no dry friction in this format";
  return "";
}

Carried law_carried(const Model& model, const diagnose::FreeLaw& law, Format format) {
  const std::string label = fmt::format("torque_law({})", law.joint);
  if (format != Format::mjcf)
    return {label, false, "joints of this format know no free torque law: the table at the head of the file"};
  if (std::any_of(law.sliders.begin(), law.sliders.end(),
                  [](const auto& one) { return !one.profile.empty(); }))
    return {label, false, "friction that changes with the deflection: the table at the head of the file"};
  const bool widens =
      std::any_of(law.sliders.begin(), law.sliders.end(), [](const auto& one) { return one.growth > 0; });
  if (widens && rig_with(model, model.experiment.effects).backlash[law.joint - 1] > 0)
    return {
        label, false,
        "friction that grows with the deflection of a joint with play: the table at the head of the file"};
  return {label, true,
          "as forces that go with the joint's angle from knot to knot, and arms beside the joint"};
}

}  // namespace

bool of_catalogue(const NominalEffect& effect) {
  const auto& rows = diagnose::catalogue();
  return std::any_of(rows.begin(), rows.end(),
                     [&](const diagnose::Effect& row) { return row.id == effect.id; });
}

std::vector<Carried> what_is_carried(const Model& model, Format format) {
  std::vector<Carried> all;
  std::vector<NominalEffect> so_far;
  for (const NominalEffect& effect : model.experiment.effects) {
    if (!of_catalogue(effect)) {
      all.push_back(
          {effect.label(), false, "an effect of your own, which this format has no expressions for"});
      continue;
    }
    const Way way = way_of(format, effect);
    Carried one{effect.label(), way.carried, std::string(way.how)};
    if (way.carried) {
      so_far.push_back(effect);
      if (const std::string_view reason = against(format, effect, rig_with(model, so_far)); !reason.empty()) {
        one = {effect.label(), false, std::string(reason)};
        so_far.pop_back();
      }
    }
    all.push_back(std::move(one));
  }
  for (const diagnose::FreeLaw& law : model.experiment.laws) all.push_back(law_carried(model, law, format));
  return all;
}

CatalogueRows rows_beside(const Model& model, const std::vector<Carried>& effects, Format format) {
  CatalogueRows rows;
  std::vector<NominalEffect> carried;
  for (std::size_t e = 0; e < model.experiment.effects.size(); ++e)
    if (effects[e].carried) carried.push_back(model.experiment.effects[e]);
  const Rig bare = rig_with(model, {});
  const bool play = plays(rig_with(model, carried));
  for (const NominalEffect& effect : carried) {
    // Of a joint with play the dry friction stands in an element of its own.
    const bool elsewhere = play && rig_with(model, {effect}).friction != bare.friction;
    if (elsewhere || !way_of(format, effect).in_place) rows.effects.push_back(effect);
  }
  for (std::size_t l = 0; l < model.experiment.laws.size(); ++l)
    if (effects[model.experiment.effects.size() + l].carried) rows.laws.push_back(model.experiment.laws[l]);
  return rows;
}

Tree carried_tree(const Model& model, const std::vector<Carried>& effects, const Means& means) {
  diagnose::Experiment part = model.experiment;
  auto carried = effects.begin();
  const auto keep = [&](auto& all) {
    std::erase_if(all, [&](const auto&) { return !(carried++)->carried; });
  };
  keep(part.effects);
  keep(part.laws);
  part.run_count = part.runs.size();
  return tree_of(diagnose::nominal_rig(part), model, means);
}

}  // namespace plumbline::exchange
