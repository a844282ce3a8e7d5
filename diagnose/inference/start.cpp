#include "diagnose/inference/start.hpp"

#include <algorithm>

namespace plumbline::diagnose {
namespace {

/// One effect's parameter, looked at on both sides of nothing.
std::vector<std::vector<double>> scan(const ParameterRange& range) {
  std::vector<std::vector<double>> result{{0}};
  for (const double value : {range.scale, -range.scale})
    if (value > range.low && value < range.high) result.push_back({value});
  return result;
}

}  // namespace

InitialGuesses initial_guesses(const Study& study, const EffectAt& at) {
  const std::vector<ParameterRange> ranges = study.ranges(at);
  if (at.effect->initial_guesses == nullptr) {
    // Every one is refined: where a chain buckles, squares have a valley on either side of the nominal model.
    // An arm in space and a joint alone come to rest near their command alone, where they have one.
    if (ranges.size() == 1 && study.experiment().is_planar()) return {scan(ranges[0]), 3};
    return {{std::vector<double>(ranges.size(), 0)}, 1};
  }
  InitialGuesses known =
      at.effect->initial_guesses({study.scales(), at.joint > 0 ? at.joint - 1 : 0}, study.excitation());
  for (std::vector<double>& start : known.points)
    for (std::size_t p = 0; p < start.size(); ++p)
      start[p] = std::clamp(start[p], ranges[p].low, ranges[p].high);
  return known;
}

InitialGuesses initial_guesses(const Study& study, const Candidate& candidate) {
  InitialGuesses all{{{}}, 1};
  for (const EffectAt& at : candidate.effects) {
    const InitialGuesses own = initial_guesses(study, at);
    std::vector<std::vector<double>> longer;
    for (const auto& head : all.points) {
      for (const auto& tail : own.points) {
        longer.push_back(head);
        longer.back().insert(longer.back().end(), tail.begin(), tail.end());
      }
    }
    all = {std::move(longer), std::max(all.refined, own.refined)};
  }
  return all;
}

}  // namespace plumbline::diagnose
