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

/// Whether both senses have one most probable cause.
bool same_cause(const Diagnosis& one, const Diagnosis& other) {
  return one.cause.is_explained() && other.cause.is_explained() &&
         one.cause.ranking.front().cause == other.cause.ranking.front().cause;
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
  const bool same = same_cause(added.diagnosis, removed.diagnosis);
  const bool either = same && std::abs(log_odds) < std::log(priors::wrong_over_further_name);
  const Sense sense = either ? Sense::either : log_odds >= 0 ? Sense::added : Sense::removed;
  Side &best = sense == Sense::removed ? removed : added, &other = sense == Sense::removed ? added : removed;
  const double probability = 1 / (1 + std::exp(-std::abs(log_odds)));
  Change change{before.experiment().name,
                after.experiment().name,
                sense,
                probability,
                std::move(best.study),
                std::move(best.diagnosis),
                std::move(best.relative.runs),
                std::nullopt};
  Cause& cause = change.diagnosis.cause;
  const std::vector<RankedCause>& ranking = other.diagnosis.cause.ranking;
  if (same || !cause.is_explained() || ranking.empty() ||
      (1 - probability) * ranking.front().probability * priors::wrong_over_further_name < 1)
    return change;
  change.otherwise = ranking.front();
  if (cause.verdict == CauseVerdict::identified) cause.verdict = CauseVerdict::ambiguous;
  return change;
}

Check check(const Change& change) {
  const double probability = change.diagnosis.gap.probability;
  if (probability < 0.05) return Check::same;
  return probability > 0.95 ? Check::changed : Check::cannot_tell;
}

}  // namespace plumbline::diagnose
