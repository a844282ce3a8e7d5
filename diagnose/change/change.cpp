#include "diagnose/change/change.hpp"

#include <cmath>

#include "diagnose/exchange/corrected.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

struct Side {
  RelativeReadings relative;
  Study study;
  Diagnosis diagnosis;
};

/// The same readings with a nominal model that has what a diagnosis of them found, or a free law in its
/// place.
Study corrected(const Study& study, const std::function<void(double)>& progress) {
  const std::vector<exchange::Corrected> models =
      exchange::corrected_models(study, diagnose(study, progress));
  if (models.empty()) return study;
  Experiment experiment = study.experiment();
  static_cast<NominalChain&>(experiment) = models.front().model.experiment;
  Study better = study.of(std::move(experiment));
  return better.nominal().reached ? better : study;
}

/// \param part  of the progress
Side side(const Study& reference, const Study& state,
          const std::function<std::function<void(double)>(int part)>& progress, int part) {
  require_one_device(reference.experiment(), state.experiment());
  const Study known = corrected(reference, progress(part));
  RelativeReadings relative = relative_to(known, state.experiment());
  relative.experiment.name = state.experiment().name + " against " + reference.experiment().name;
  Study study = known.of(relative.experiment);
  Diagnosis diagnosis = diagnose(study, progress(part + 1));
  return {std::move(relative), std::move(study), std::move(diagnosis)};
}

std::vector<std::string> labels(const Candidate& cause) {
  std::vector<std::string> all;
  for (const EffectAt& at : cause.effects) all.push_back(at.label());
  return all;
}

}  // namespace

Change what_changed(const Study& before, const Study& after, const std::function<void(double)>& progress) {
  const auto quarter = [&](int part) -> std::function<void(double)> {
    return [&progress, part](double share) {
      if (progress) progress((part + share) / 4);
    };
  };
  Side added = side(before, after, quarter, 0), removed = side(after, before, quarter, 2);
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
