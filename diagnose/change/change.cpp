#include "diagnose/change/change.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/exchange/corrected.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

struct Side {
  RelativeReadings relative;
  Study study;
  Diagnosis diagnosis;
  /// Logarithm of the share of the prior that the model of the reference keeps.
  double log_simplicity;
  /// Power at which the evidence counts between the senses: neighbouring readings share what the model of the
  /// reference lacks.
  double power;
};

/// The same readings with a nominal model that has what a diagnosis of them found, or a free law in its
/// place.
Study corrected(const Study& study, const Diagnosis& diagnosis) {
  const std::vector<exchange::Corrected> models = exchange::corrected_models(study, diagnosis);
  if (models.empty()) return study;
  Experiment experiment = study.experiment();
  static_cast<NominalChain&>(experiment) = models.front().model.experiment;
  Study better = study.of(std::move(experiment));
  return better.nominal().reached ? better : study;
}

/// Of the best model of a state: the probability that it is the one, and the share of its parameters' prior
/// that the readings leave.
double log_simplicity(const Diagnosis& diagnosis) {
  if (!diagnosis.gap.present || diagnosis.cause.ranking.empty()) return std::log(priors::no_gap);
  const Hypothesis& best = diagnosis.cause.ranking.front().hypothesis;
  return std::log((1 - priors::no_gap) * (1 - priors::outside)) + best.log_prior + best.log_volume;
}

/// \param part  of the progress
Side side(const Study& reference, const Study& state,
          const std::function<std::function<void(double)>(int part)>& progress, int part) {
  require_one_device(reference.experiment(), state.experiment());
  const Diagnosis alone = diagnose(reference, progress(part));
  const Study known = corrected(reference, alone);
  RelativeReadings relative = relative_to(known, state.experiment());
  relative.experiment.name = state.experiment().name + " against " + reference.experiment().name;
  Study study = known.of(relative.experiment);
  Diagnosis diagnosis = diagnose(study, progress(part + 1));
  return {std::move(relative), std::move(study), std::move(diagnosis), log_simplicity(alone),
          alone.cause.leaves_a_rest() ? priors::temper : 1};
}

/// The causes of a sense with this probability that are worth naming beside those of the likelier one.
std::vector<RankedCause> worth_naming(const Side& side, double probability) {
  std::vector<RankedCause> worth;
  for (const RankedCause& one : side.diagnosis.cause.ranking)
    if (probability * one.probability * priors::wrong_over_further_name >= 1) worth.push_back(one);
  return worth;
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
  const double power = std::min(added.power, removed.power),
               of_change = power * (added.diagnosis.gap.log_odds - removed.diagnosis.gap.log_odds);
  const bool same = same_cause(added.diagnosis, removed.diagnosis);
  const bool either = same && std::abs(of_change) < std::log(priors::wrong_over_further_name);
  const double log_odds = of_change + power * (added.log_simplicity - removed.log_simplicity);
  const Sense sense = either ? Sense::either : log_odds >= 0 ? Sense::added : Sense::removed;
  Side &best = sense == Sense::removed ? removed : added, &other = sense == Sense::removed ? added : removed;
  const double probability = 1 / (1 + std::exp(-std::abs(log_odds)));
  Change change{before.experiment().name,
                after.experiment().name,
                sense,
                either ? 1 : probability,
                std::move(best.study),
                std::move(best.diagnosis),
                std::move(best.relative.runs),
                {}};
  Cause& cause = change.diagnosis.cause;
  if (same || !cause.is_explained()) return change;
  // Where the change by itself speaks for the other sense, and the references for this one, one of both is
  // mistaken: then both senses are named.
  const double least_sure = std::min(std::abs(log_odds), sense == Sense::removed ? -of_change : of_change);
  change.otherwise = worth_naming(other, 1 / (1 + std::exp(least_sure)));
  if (cause.verdict == CauseVerdict::identified && !change.otherwise.empty())
    cause.verdict = CauseVerdict::ambiguous;
  return change;
}

Check check_of(double probability) {
  if (probability < priors::check_is_sure) return Check::same;
  return probability > 1 - priors::check_is_sure ? Check::changed : Check::cannot_tell;
}

Check check(const Change& change) {
  return check_of(change.diagnosis.gap.seen);
}

}  // namespace plumbline::diagnose
