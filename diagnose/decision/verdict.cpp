#include "diagnose/decision/verdict.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numbers>
#include <plumbline/base/parallel.hpp>

#include "diagnose/beliefs.hpp"
#include "diagnose/decision/alike.hpp"
#include "diagnose/decision/genuine.hpp"
#include "diagnose/noise/outliers.hpp"
#include "diagnose/decision/rival.hpp"

namespace plumbline::diagnose {
namespace {

/// What an explanation may leave of a reading.
const NoiseModel& allowed(const Findings& findings) {
  return findings.tolerance ? *findings.tolerance : findings.noise;
}

/// Posterior probabilities of the genuine hypotheses, of all where none is genuine; of several forms of one
/// cause of that with the most evidence alone.
std::vector<Ranked> ranked(const Study& study, const Findings& findings) {
  const auto stands = [&](const Hypothesis& one) { return genuine(study, one.fit); };
  const bool any = std::any_of(findings.hypotheses.begin(), findings.hypotheses.end(), stands);
  std::vector<Ranked> ranking;
  double sum = 0;
  for (const Hypothesis& hypothesis : findings.hypotheses) {
    if (any && !stands(hypothesis)) continue;
    const Candidate& candidate = hypothesis.fit.candidate;
    if (std::any_of(ranking.begin(), ranking.end(), [&](const Ranked& better) {
          return better.hypothesis.fit.candidate.is_form_of(candidate);
        }))
      continue;
    const double best = ranking.empty() ? hypothesis.log_evidence : ranking.front().hypothesis.log_evidence;
    ranking.push_back({hypothesis, std::exp(hypothesis.log_evidence - best),
                       chi2_per_dof(study.measurements(), hypothesis.fit, allowed(findings))});
    sum += ranking.back().probability;
  }
  for (Ranked& one : ranking) one.probability /= sum;
  return ranking;
}

}  // namespace

Findings confirmed(const Study& study, const Findings& found) {
  // More readings cannot lift what fell behind by so much, unless it is a part of what leads.
  constexpr double hopeless = 50;
  const auto is_behind = [&](const Hypothesis& one) {
    const Hypothesis& leading = found.hypotheses.front();
    return one.log_evidence < leading.log_evidence - hopeless &&
           !contains(leading.fit.candidate, one.fit.candidate);
  };
  FitSettings settings;
  settings.noise = found.noise;
  const auto refitted = [&](const Fit& one) {
    return fit_from(study, one.candidate, settings, one.parameters);
  };
  std::vector<Fit> fits(found.hypotheses.size());
  in_parallel(fits.size(), study.threads(), [&](std::size_t i) {
    if (!is_behind(found.hypotheses[i])) fits[i] = refitted(found.hypotheses[i].fit);
  });
  Findings all;
  all.tolerance = found.tolerance;
  std::size_t standing = 0;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    if (is_behind(found.hypotheses[i])) {
      if (standing >= 2) continue;
      fits[i] = refitted(found.hypotheses[i].fit);
    }
    if (!fits[i].converged) continue;
    standing += genuine(study, fits[i]);
    all.hypotheses.push_back({std::move(fits[i]), 0, 0, {}});
  }
  weigh(study, all);
  return all;
}

namespace {

/// The first of the ranking with so many effects, or the end.
std::size_t first_of(const std::vector<Ranked>& ranking, std::size_t effects) {
  const auto place = std::find_if(ranking.begin(), ranking.end(), [&](const Ranked& one) {
    return one.hypothesis.fit.candidate.count() == effects;
  });
  return static_cast<std::size_t>(place - ranking.begin());
}

/// The absolute test of a fit: for structure in what it leaves; where more is tolerated, for more than
/// that.
double fit_p_value(const Measurements& measurements, const Findings& findings, const Fit& fit) {
  if (fit.parameters.size() >= measurements.size()) return 0;
  if (!findings.tolerance) return structure_p_value(measurements, fit.residual);
  const double dof = degrees_of_freedom(measurements, fit);
  return boost::math::cdf(
      boost::math::complement(boost::math::chi_squared_distribution<double>(dof),
                              dof * chi2_per_dof(measurements, fit, *findings.tolerance)));
}

/// What a fit gains over a simpler one of log-likelihood, in the noise that the simpler one leaves, or in
/// what is tolerated (in its own, what it has fitted of correlated noise would count for it), and of the
/// log-prior of what tolerances hold: the simpler one may have stretched these to what the fuller one names.
double gain(const Study& study, const Findings& findings, const Fit& simpler, const Fit& fuller) {
  const Measurements& measurements = study.measurements();
  const NoiseModel noise =
      findings.tolerance ? findings.noise
                         : estimate_noise(measurements, without_outliers(measurements, simpler.residual));
  const auto log_posterior = [&](const Fit& fit) {
    return log_likelihood(measurements, fit.residual, noise) - tolerance_charge(study, fit) / 2;
  };
  return log_posterior(fuller) - log_posterior(simpler);
}

/// The simplest explanation that leaves no structure, unless one more effect is significant at all the places
/// where it could have been found and has more evidence with all the values that come with it, or has more by
/// far; the end of the ranking when none suffices.
std::size_t choose(const Study& study, const Findings& findings, std::vector<Ranked>& ranking) {
  const double significant =
      beliefs::told_apart + std::log(static_cast<double>(possible_effects(study).size()));
  std::size_t chosen = ranking.size();
  for (std::size_t effects = 1; effects <= 3; ++effects) {
    const std::size_t place = first_of(ranking, effects);
    if (place == ranking.size()) continue;
    Hypothesis& one = ranking[place].hypothesis;
    if (!genuine(study, one.fit)) continue;
    one.p_value = fit_p_value(study.measurements(), findings, one.fit);
    if (*one.p_value < beliefs::fit_level) continue;
    if (chosen == ranking.size()) {
      chosen = place;
      continue;
    }
    const Hypothesis& simpler = ranking[chosen].hypothesis;
    const auto more = static_cast<double>(effects - simpler.fit.candidate.count());
    const double better = one.log_evidence - simpler.log_evidence;
    if (better > beliefs::told_apart ||
        (better > 0 && gain(study, findings, simpler.fit, one.fit) > more * significant))
      chosen = place;
  }
  return chosen;
}

/// Probability that the cause is outside the catalogue, from the test of what the best explanation leaves.
/// The odds against it go with the mean density of the p-values that a wrong one might have, over all shapes
/// xi p^(xi - 1) (Sellke, Bayarri and Berger 2001), 2 (1 - p + p ln p) / (p ln^2 p), so that nothing is held
/// against it where p is one; an explanation from the catalogue that fits by chance is rarer still, by the
/// factor that simulated experiments show. No p-value says more than that a listed cause is refused too,
/// where the bench has something of its own beside it.
double probability_of_unknown(double p_value) {
  constexpr double prior_odds = beliefs::outside / (1 - beliefs::outside);
  const double p = std::clamp(p_value, 1e-300, 1 - 1e-4), log_p = std::log(p);
  const double against = 2 * (1 - p + p * log_p) / (p * log_p * log_p);
  const double odds = prior_odds * std::min(beliefs::fits_by_chance * against,
                                            (1 - beliefs::fits_by_chance) / beliefs::misfit);
  return odds / (1 + odds);
}

}  // namespace

double partial_criterion(const Measurements& measurements, const Fit& fit) {
  const double independent = static_cast<double>(measurements.size()) / beliefs::share_a_misfit;
  double squares = 0;
  for (const double z : whiten(measurements, without_outliers(measurements, fit.residual), fit.noise))
    squares += z * z;
  return independent * std::log(squares) +
         static_cast<double>(fit.parameters.size()) * std::log(std::max(independent, 2.0));
}

std::size_t best_partial(const Measurements& measurements, const std::vector<const Fit*>& fits) {
  const auto place = std::min_element(fits.begin(), fits.end(), [&](const Fit* a, const Fit* b) {
    return partial_criterion(measurements, *a) < partial_criterion(measurements, *b);
  });
  return static_cast<std::size_t>(place - fits.begin());
}

Cause judge(const Study& study, const Findings& findings) {
  Cause cause;
  cause.ranking = ranked(study, findings);
  cause.verdict = CauseVerdict::unknown;
  const std::size_t chosen = choose(study, findings, cause.ranking);
  double p_value = 0;
  for (const Ranked& one : cause.ranking) p_value = std::max(p_value, one.hypothesis.p_value.value_or(0));
  cause.unknown = probability_of_unknown(p_value);
  const bool compound =
      chosen < cause.ranking.size() && cause.ranking[chosen].hypothesis.fit.candidate.effects.size() > 1;
  if (compound) cause.unknown = std::max(cause.unknown, beliefs::wrong_compound);
  for (Ranked& one : cause.ranking) one.probability *= 1 - cause.unknown;
  if (chosen == cause.ranking.size()) {
    std::vector<const Fit*> partial;
    for (const Ranked& one : cause.ranking) partial.push_back(&one.hypothesis.fit);
    if (!partial.empty()) cause.best = best_partial(study.measurements(), partial);
    return cause;
  }
  settle_on(cause, chosen, cause.unknown);
  list_plainer(study, allowed(findings), cause);
  drop_refinements(cause);
  return cause;
}

}  // namespace plumbline::diagnose
