#include "diagnose/decision/rival.hpp"

#include <algorithm>

namespace plumbline::diagnose {

bool covers(const EffectAt& whole, const EffectAt& part) {
  const std::vector<std::string_view>& nested = whole.effect->nested;
  return whole == part || std::find(nested.begin(), nested.end(), part.effect->id) != nested.end();
}

bool contains(const Candidate& whole, const Candidate& part) {
  return whole.effects.size() >= part.effects.size() &&
         std::all_of(part.effects.begin(), part.effects.end(), [&](const EffectAt& at) {
           return std::any_of(whole.effects.begin(), whole.effects.end(),
                              [&](const EffectAt& other) { return covers(other, at); });
         });
}

namespace {

/// Whether the values of an effect can make the change that another is.
bool can_make(const EffectAt& values, const EffectAt& change) {
  const std::vector<std::string_view>& within = values.effect->within_values;
  return std::find(within.begin(), within.end(), change.effect->id) != within.end();
}

/// The effects of one that the other has not.
std::vector<EffectAt> without(const Candidate& one, const Candidate& other) {
  std::vector<EffectAt> rest;
  for (const EffectAt& at : one.effects)
    if (std::find(other.effects.begin(), other.effects.end(), at) == other.effects.end()) rest.push_back(at);
  return rest;
}

}  // namespace

bool has_at_each(const Candidate& plain, const Candidate& other) {
  const std::vector<EffectAt> one = without(plain, other), values = without(other, plain);
  return one.size() == 1 && values.size() == 1 && can_make(values.front(), one.front());
}

bool singles_out(const Candidate& machining, const Candidate& other) {
  if (!machining.has_all_tolerances() || !without(machining, other).empty()) return false;
  const std::vector<EffectAt> more = without(other, machining);
  return more.size() == 1 &&
         std::any_of(machining.effects.begin(), machining.effects.end(),
                     [&](const EffectAt& values) { return can_make(values, more.front()); });
}

std::size_t many_valued(const Study& study, const Candidate& candidate) {
  constexpr std::size_t few = 4;
  const auto count = std::count_if(
      candidate.effects.begin(), candidate.effects.end(),
      [&](const EffectAt& at) { return !candidate.has_as_tolerance(at) && study.ranges(at).size() > few; });
  return static_cast<std::size_t>(count);
}

}  // namespace plumbline::diagnose
