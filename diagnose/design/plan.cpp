#include "diagnose/design/plan.hpp"

#include <algorithm>
#include <numeric>

#include "diagnose/design/comparison.hpp"

namespace plumbline::diagnose {
namespace {

using Places = std::vector<std::size_t>;

/// The effects that runs detect, and the pairs that they distinguish.
struct Shown {
  Places seen;
  std::vector<std::vector<bool>> distinguished;
};

/// \param suffice  whether the runs suffice for some contrasts
Shown shown_by(const Comparison& effects, const std::function<bool(const std::vector<Contrast>&)>& suffice) {
  Shown result{{}, {effects.size(), std::vector<bool>(effects.size(), false)}};
  for (std::size_t i = 0; i < effects.size(); ++i)
    if (suffice({effects.gap(i)})) result.seen.push_back(i);
  for (const std::size_t i : result.seen)
    for (const std::size_t j : result.seen)
      if (j > i) result.distinguished[i][j] = result.distinguished[j][i] = suffice(effects.between(i, j));
  return result;
}

/// Groups effects by their sets of indistinguishable effects, each of which contains the effect itself.
std::vector<Indistinguishable> indistinguishable(const Comparison& effects, const Shown& told,
                                                 const Places& all) {
  std::vector<Places> near(effects.size());
  for (const std::size_t i : told.seen)
    for (const std::size_t j : told.seen)
      if (!told.distinguished[i][j]) near[i].push_back(j);
  std::vector<Indistinguishable> result;
  std::vector<bool> taken(effects.size(), false);
  for (const std::size_t i : told.seen) {
    if (taken[i] || near[i].size() < 2) continue;
    Indistinguishable one;
    Places members;
    for (const std::size_t j : near[i]) {
      const bool same = near[j] == near[i];
      (same ? one.effects : one.others).push_back(effects.effect(j));
      taken[j] = taken[j] || same;
      if (same) members.push_back(j);
    }
    one.exactly = members.size() > 1 && std::all_of(members.begin() + 1, members.end(), [&](std::size_t j) {
                    return effects.distinguishability(members.front(), j, all) < same_readings;
                  });
    result.push_back(std::move(one));
  }
  return result;
}

Unidentifiable unidentifiable(const Comparison& effects, const Shown& told, const Places& runs) {
  Unidentifiable left;
  for (std::size_t i = 0; i < effects.size(); ++i)
    if (std::find(told.seen.begin(), told.seen.end(), i) == told.seen.end())
      left.undetectable.push_back(effects.effect(i));
  left.indistinguishable = indistinguishable(effects, told, runs);
  return left;
}

Places first(std::size_t count) {
  Places runs(count);
  std::iota(runs.begin(), runs.end(), std::size_t{0});
  return runs;
}

}  // namespace

Plan plan(const Experiment& bench, const std::function<void(double)>& progress) {
  const DesignSpace space = design_space(bench);
  const Comparison effects(space, progress);
  const std::size_t count = space.descriptions.size();
  const Shown told = shown_by(effects, [&](const std::vector<Contrast>& contrasts) {
    return few_suffice(contrasts, count, told_apart, few_runs);
  });
  Plan result;
  result.experiment = bench.name;
  result.impossible = space.impossible;
  result.candidates = count;
  result.unidentifiable = unidentifiable(effects, told, first(count));
  if (const Places planned = first(space.planned); !planned.empty()) {
    const auto suffice = [&](const std::vector<Contrast>& contrasts) {
      return std::all_of(contrasts.begin(), contrasts.end(), [&](const Contrast& one) {
        return expected_log_likelihood_ratio(one, planned) > told_apart;
      });
    };
    result.planned = unidentifiable(effects, shown_by(effects, suffice), planned);
  }
  std::vector<Contrast> to_be_shown;
  for (const std::size_t i : told.seen) {
    to_be_shown.push_back(effects.gap(i));
    for (const std::size_t j : told.seen) {
      if (j <= i || !told.distinguished[i][j]) continue;
      ++result.separated;
      for (Contrast& one : effects.between(i, j)) to_be_shown.push_back(std::move(one));
    }
  }
  const FewestRuns fewest = fewest_runs(to_be_shown, count, told_apart);
  for (const std::size_t run : fewest.runs) result.fewest.push_back(space.descriptions[run]);
  result.proved_minimal = fewest.proved;
  return result;
}

}  // namespace plumbline::diagnose
