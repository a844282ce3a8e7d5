#include "diagnose/change/change.hpp"

#include <cmath>

#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

struct Side {
  RelativeReadings relative;
  Study study;
  Diagnosis diagnosis;
};

Side side(const Study& reference, const Study& state, const std::function<void(double)>& progress) {
  RelativeReadings relative = relative_to(reference, state.experiment());
  relative.experiment.name = state.experiment().name + " against " + reference.experiment().name;
  Study study = state.of(relative.experiment);
  Diagnosis diagnosis = diagnose(study, progress);
  return {std::move(relative), std::move(study), std::move(diagnosis)};
}

std::vector<std::string> labels(const Candidate& cause) {
  std::vector<std::string> all;
  for (const EffectAt& at : cause.effects) all.push_back(at.label());
  return all;
}

}  // namespace

Change what_changed(const Study& before, const Study& after, const std::function<void(double)>& progress) {
  const auto half = [&](double done) {
    return [&progress, done](double share) {
      if (progress) progress(done + share / 2);
    };
  };
  Side added = side(before, after, half(0)), removed = side(after, before, half(0.5));
  const double log_odds = added.diagnosis.gap.log_odds - removed.diagnosis.gap.log_odds;
  const Sense sense = log_odds >= 0 ? Sense::added : Sense::removed;
  Side &best = sense == Sense::added ? added : removed, &other = sense == Sense::added ? removed : added;
  const double probability = 1 / (1 + std::exp(-std::abs(log_odds)));
  Change change{before.experiment().name,
                after.experiment().name,
                sense,
                probability,
                std::move(best.study),
                std::move(best.diagnosis),
                std::move(best.relative.runs),
                std::nullopt};
  const std::vector<RankedCause>& ranking = other.diagnosis.cause.ranking;
  if (!change.diagnosis.gap.present || ranking.empty() || change.diagnosis.cause.ranking.empty())
    return change;
  if ((1 - probability) * ranking.front().probability * priors::wrong_over_further_name < 1 ||
      labels(ranking.front().cause) == labels(change.diagnosis.cause.ranking.front().cause))
    return change;
  change.otherwise = ranking.front();
  if (change.diagnosis.cause.verdict == CauseVerdict::identified)
    change.diagnosis.cause.verdict = CauseVerdict::ambiguous;
  return change;
}

Check check(const Change& change) {
  const double probability = change.diagnosis.gap.probability;
  if (probability < 0.05) return Check::same;
  return probability > 0.95 ? Check::changed : Check::cannot_tell;
}

}  // namespace plumbline::diagnose
