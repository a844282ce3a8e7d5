#include "diagnose/rig/effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <plumbline/base/error.hpp>

#include "diagnose/rig/effects/rows.hpp"

namespace plumbline::diagnose {

double catalogue_value(Coordinate coordinate, double fitted) {
  switch (coordinate) {
    case Coordinate::logarithm:
      return std::exp(fitted);
    case Coordinate::reciprocal:
      return 1 / fitted;
    case Coordinate::plain:
      break;
  }
  return fitted;
}

double fitted_value(Coordinate coordinate, double catalogue_units) {
  switch (coordinate) {
    case Coordinate::logarithm:
      return std::log(catalogue_units);
    case Coordinate::reciprocal:
      return 1 / catalogue_units;
    case Coordinate::plain:
      break;
  }
  return catalogue_units;
}

ParameterRange both_ways(std::string_view name, std::string_view unit, double scale, double low,
                         double high) {
  return {name, unit, Coordinate::plain, scale, low, high, 0};
}

ParameterRange one_way(std::string_view name, std::string_view unit, double scale, double high) {
  return {name, unit, Coordinate::plain, scale, 0, high, 0};
}

const std::vector<Effect>& catalogue() {
  static const std::vector<Effect> all = [] {
    std::vector<Effect> rows;
    for (const auto& group : {joint_effects, link_effects, bench_effects, load_cell_effects, common_effects,
                              joint_law_effects, friction_effects, instrument_effects})
      for (Effect& row : group()) rows.push_back(std::move(row));
    return rows;
  }();
  return all;
}

const std::vector<Effect>& arm_catalogue() {
  static const std::vector<Effect> all = [] {
    std::vector<Effect> rows;
    for (const auto& group : {arm_joint_effects, arm_tool_effects, arm_bench_effects})
      for (Effect& row : group()) rows.push_back(std::move(row));
    return rows;
  }();
  return all;
}

std::vector<const Effect*> rows_for(bool arm) {
  std::vector<const Effect*> rows;
  for (const Effect& row : catalogue())
    if (!arm || row.in_space) rows.push_back(&row);
  if (!arm) return rows;
  for (const Effect& row : arm_catalogue()) rows.push_back(&row);
  return rows;
}

const Effect& effect(std::string_view id, std::size_t joint) {
  const Effect* named = nullptr;
  for (const std::vector<Effect>* rows : {&catalogue(), &arm_catalogue()})
    for (const Effect& row : *rows)
      if (row.id == id &&
          (named == nullptr || (row.at_joint == (joint > 0) && row.at_joint != named->at_joint)))
        named = &row;
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
  const auto has_those_of = [&](bool arm) {
    const std::vector<const Effect*> rows = rows_for(arm);
    return std::all_of(rows.begin(), rows.end(),
                       [&](const Effect* row) { return !row->is_tolerance || has(EffectAt(*row)); });
  };
  return has_those_of(false) || has_those_of(true);
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
