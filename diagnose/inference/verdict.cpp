#include "diagnose/inference/verdict.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numbers>
#include <plumbline/base/parallel.hpp>

#include "diagnose/beliefs.hpp"
#include "diagnose/inference/rival.hpp"

namespace plumbline::diagnose {
namespace {

/// Degrees of freedom that a fit leaves to the readings.
double freedom(const Measurements& measurements, const Fit& fit) {
  const std::size_t values = measurements.size(), parameters = fit.parameters.size();
  return static_cast<double>(values > parameters ? values - parameters : 1);
}

/// What an explanation may leave of a reading.
const NoiseModel& allowed(const Findings& findings) {
  return findings.tolerance ? *findings.tolerance : findings.noise;
}

/// Whether the readings tell a parameter, were it the only one, to a third of its value: where a stop begins
/// that nothing touched, or an element that never yielded would, is anybody's guess.
bool known_to_itself(const Fit& fit, std::size_t parameter) {
  const auto p = static_cast<Eigen::Index>(parameter);
  return fit.information(p, p) * fit.parameters[parameter] * fit.parameters[parameter] > 9;
}

/// Whether a set of effects is another one and more: as many at least, for one may be a special case of each
/// of several.
bool contains(const Candidate& whole, const Candidate& part) {
  return whole.effects.size() >= part.effects.size() &&
         std::all_of(part.effects.begin(), part.effects.end(), [&](const EffectAt& at) {
           return std::any_of(whole.effects.begin(), whole.effects.end(),
                              [&](const EffectAt& other) { return covers(other, at); });
         });
}

/// Whether parameters are farther from zero than their standard deviations: one of them, or all together,
/// where each could take the place of another.
bool are_beyond_zero(const Fit& fit, const std::vector<Eigen::Index>& parameters) {
  const Eigen::Map<const Eigen::VectorXd> all(fit.parameters.data(),
                                              static_cast<Eigen::Index>(fit.parameters.size()));
  std::vector<Eigen::Index> free;
  for (const Eigen::Index p : parameters) {
    if (all[p] * all[p] > fit.covariance(p, p)) return true;
    if (fit.covariance(p, p) > 0) free.push_back(p);
  }
  if (free.empty()) return false;
  const Eigen::VectorXd values = all(free);
  const Eigen::MatrixXd spread = fit.covariance(free, free);
  return values.dot(spread.ldlt().solve(values)) > static_cast<double>(free.size());
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

double chi2_per_dof(const Measurements& measurements, const Fit& fit, const NoiseModel& noise) {
  double sum = 0;
  for (const double z : whiten(measurements, without_outliers(measurements, fit.residual), noise))
    sum += huber(z, FitSettings().outlier_bound);
  return sum / freedom(measurements, fit);
}

std::string verdict_word(CauseVerdict verdict) {
  switch (verdict) {
    case CauseVerdict::none:
      return "none";
    case CauseVerdict::identified:
      return "identified";
    case CauseVerdict::ambiguous:
      return "ambiguous";
    case CauseVerdict::unknown:
      break;
  }
  return "unknown";
}

std::string reservation_words(Reservation reservation) {
  switch (reservation) {
    case Reservation::none:
      break;
    case Reservation::not_tested:
      return "no readings that can be held out show enough of the gap to test it";
    case Reservation::not_predicted:
      return "fitted without the held-out readings, it does not predict them";
    case Reservation::one_run:
      return "it shows in one run alone, so that no other run tests where it sets in: a wall, or "
             "whatever else the chain met there, would do the same";
    case Reservation::beyond_noise:
      return "it leaves more than the readings scatter, though no more than is tolerated";
    case Reservation::small_gap:
      return "it takes two effects, and noise is more than a tenth of the gap in the readings held out: so "
             "much two may imitate of a third";
    case Reservation::many_values:
      return "an effect with a value at every joint, link or run, many of them or beside another effect, "
             "explains much that it is not";
    case Reservation::machining_alone:
      return "what machining leaves has values at every joint or link, in which a cause of another kind may "
             "hide";
    case Reservation::beyond_tolerance:
      return "its tolerances are wider than machining leaves";
    case Reservation::single_joint:
      return "it closes nearly all of the gap, beside a spring that is not as it was believed, but leaves "
             "more "
             "than the readings scatter";
  }
  return "";
}

bool genuine(const Study& study, const Fit& fit) {
  // What machining leaves is one cause: of its three kinds one may be nothing here.
  const bool machined = fit.candidate.machined();
  std::vector<Eigen::Index> machining;
  std::size_t p = 0;
  for (const EffectAt& at : fit.candidate.effects) {
    std::size_t acting = 0;
    bool begins = false, seen = false, away = false, element_is_idle = false;
    std::vector<Eigen::Index> from_zero;
    const std::vector<ParameterRange> ranges = study.ranges(at);
    for (std::size_t own = 0; own < ranges.size(); ++own) {
      const ParameterRange& range = ranges[own];
      const bool natural_zero = range.may_be_nothing();
      const bool at_zero = fit.at_bound[p] && natural_zero && std::abs(fit.parameters[p]) < range.scale;
      // Where the readings hardly tell a parameter from nothing it runs to the end of its range for nothing.
      const bool idle = at_zero || (fit.at_bound[p] && natural_zero && !known_to_itself(fit, p));
      // Of several elements one may be nothing: wherever it would set in.
      const bool first_of_element = at.effect->element > 0 && own % at.effect->element == 0;
      if (first_of_element) element_is_idle = idle;
      const bool of_idle_element = at.effect->element > 0 && !first_of_element && element_is_idle;
      if (fit.at_bound[p] && !idle && !of_idle_element) return false;
      acting += (natural_zero && !idle) || range.coordinate == Coordinate::reciprocal;
      away = away || !natural_zero;
      from_zero.push_back(static_cast<Eigen::Index>(p));
      if (range.is_onset()) {
        begins = true;
        seen = seen || known_to_itself(fit, p);
      }
      ++p;
    }
    const bool of_machining = fit.candidate.has_as_machining(at);
    if (of_machining) machining.insert(machining.end(), from_zero.begin(), from_zero.end());
    if (acting < at.effect->at_least || (begins && !seen)) return false;
    if (!of_machining && !away && !are_beyond_zero(fit, from_zero)) return false;
  }
  return !machined || are_beyond_zero(fit, machining);
}

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
  const double dof = freedom(measurements, fit);
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
/// The odds are those of Sellke, Bayarri and Berger (2001), 1 / (-e p ln p), for a p-value below 1/e; an
/// explanation from the catalogue that fits by chance is rarer still, by the factor that simulated
/// experiments show. No p-value says more than that a listed cause is refused too, where the bench has
/// something of its own beside it.
double probability_of_unknown(double p_value) {
  constexpr double prior_odds = beliefs::outside / (1 - beliefs::outside);
  const double p = std::clamp(p_value, 1e-300, std::exp(-1.0));
  const double odds = prior_odds * std::min(beliefs::fits_by_chance / (-std::numbers::e * p * std::log(p)),
                                            (1 - beliefs::fits_by_chance) / beliefs::misfit);
  return odds / (1 + odds);
}

/// Whether the likelihood that a refinement gains by its further parameters is more than chance would give.
bool gains_more_than_chance(const Hypothesis& best, const Hypothesis& refined) {
  if (refined.fit.parameters.size() <= best.fit.parameters.size()) return false;
  const auto further = static_cast<double>(refined.fit.parameters.size() - best.fit.parameters.size());
  const boost::math::chi_squared_distribution<double> chance(further);
  return 2 * (refined.log_likelihood - best.log_likelihood) >
         boost::math::quantile(boost::math::complement(chance, beliefs::refines_by_chance));
}

/// Whether an explanation, not the best one with something added, comes near the best: in evidence; or, of no
/// more effects and parameters, and no refinement, in likelihood; or is a refinement that gains more of that
/// than chance. Any other with more parameters comes as near as one likes. Beside machining alone a cause may
/// be added: its many values stretch to what one of another kind would do.
bool near(const Hypothesis& best, const Hypothesis& other) {
  const bool as_many = other.fit.candidate.count() == best.fit.candidate.count(),
             more_of_it = contains(other.fit.candidate, best.fit.candidate);
  const bool machining_alone = best.fit.candidate.machined() && best.fit.candidate.count() == 1;
  if (more_of_it && !as_many && !machining_alone) return false;
  const bool simpler =
      as_many && !more_of_it && other.fit.parameters.size() <= best.fit.parameters.size() + spare_parameters;
  return other.log_evidence > best.log_evidence - beliefs::told_apart ||
         (simpler && other.log_likelihood > best.log_likelihood - beliefs::told_apart) ||
         (more_of_it && as_many && gains_more_than_chance(best, other));
}

/// Places of what tolerances alone tell from an explanation: what has a value at each joint where it has one,
/// for all or at a single joint; where machining is all, the most probable changes that its values may hide.
std::vector<std::size_t> told_by_tolerances(const Cause& cause, std::size_t chosen) {
  const auto at = [&](std::size_t place) -> const Hypothesis& { return cause.ranking[place].hypothesis; };
  const Hypothesis& best = at(chosen);
  std::vector<std::size_t> places;
  std::optional<double> likeliest;
  for (std::size_t i = 0; i < cause.ranking.size(); ++i) {
    if (at(i).log_evidence < best.log_evidence - beliefs::told_by_tolerances) continue;
    const Candidate &one = best.fit.candidate, &other = at(i).fit.candidate;
    const bool singled = one.count() == 1 && singles_out(one, other);
    if (singled && !likeliest) likeliest = at(i).log_evidence;
    if (has_at_each(one, other) || (singled && at(i).log_evidence > *likeliest - beliefs::told_apart))
      places.push_back(i);
  }
  return places;
}

/// How much of the gap an explanation closes, as a share of what the best one closes.
double share_of_best(double nominal, const Ranked& best, const Ranked& other) {
  return (nominal - other.chi2_per_dof) / (nominal - best.chi2_per_dof);
}

/// Lists beside the best explanation the plainer ones of which it is a refinement, or that it has one effect
/// more than, where these close the gap nearly as well: what it adds answers then to little, which may be
/// anything.
void list_plainer(const Study& study, const NoiseModel& noise, Cause& cause) {
  Fit nothing;
  nothing.residual = study.nominal_residual();
  const double nominal = chi2_per_dof(study.measurements(), nothing, noise);
  const Ranked& best = cause.ranking[cause.best];
  for (std::size_t i = 0; i < cause.ranking.size(); ++i) {
    const Ranked& other = cause.ranking[i];
    const std::vector<std::size_t>& known = cause.equivalent;
    if (i == cause.best || std::find(known.begin(), known.end(), i) != known.end()) continue;
    const Candidate &refined = best.hypothesis.fit.candidate, &plainer = other.hypothesis.fit.candidate;
    if (plainer.count() <= refined.count() && contains(refined, plainer) &&
        share_of_best(nominal, best, other) > beliefs::closes_alike)
      cause.equivalent.push_back(i);
  }
  if (!cause.equivalent.empty()) cause.verdict = CauseVerdict::ambiguous;
}

/// Takes from the class what comes near the best in likelihood alone and is another of the class with
/// something added: to that one anything could be added. What the best hides is the best with something
/// added, and stays.
void drop_refinements(Cause& cause) {
  const auto at = [&](std::size_t place) -> const Hypothesis& { return cause.ranking[place].hypothesis; };
  const std::vector<std::size_t> listed = cause.equivalent;
  std::erase_if(cause.equivalent, [&](std::size_t one) {
    return at(one).log_evidence < at(cause.best).log_evidence - beliefs::told_apart &&
           !contains(at(one).fit.candidate, at(cause.best).fit.candidate) &&
           std::any_of(listed.begin(), listed.end(), [&](std::size_t other) {
             return other != one && contains(at(one).fit.candidate, at(other).fit.candidate);
           });
  });
}

}  // namespace

double partial_criterion(const Measurements& measurements, const Fit& fit) {
  const double independent = static_cast<double>(measurements.size()) / beliefs::share_a_misfit;
  return independent * std::log(fit.cost) +
         static_cast<double>(fit.parameters.size()) * std::log(std::max(independent, 2.0));
}

std::size_t best_partial(const Measurements& measurements, const std::vector<const Fit*>& fits) {
  const auto place = std::min_element(fits.begin(), fits.end(), [&](const Fit* a, const Fit* b) {
    return partial_criterion(measurements, *a) < partial_criterion(measurements, *b);
  });
  return static_cast<std::size_t>(place - fits.begin());
}

void settle_on(Cause& cause, std::size_t chosen, double unknown) {
  double sum = 0;
  const double leading = cause.ranking.front().hypothesis.log_evidence;
  for (Ranked& one : cause.ranking) sum += one.probability = std::exp(one.hypothesis.log_evidence - leading);
  for (Ranked& one : cause.ranking) one.probability *= (1 - unknown) / sum;
  cause.unknown = unknown;
  cause.best = chosen;
  cause.equivalent.clear();
  const Hypothesis& best = cause.ranking[chosen].hypothesis;
  double with_equals = cause.ranking[chosen].probability;
  const auto list = [&](std::size_t i) {
    const auto& known = cause.equivalent;
    if (i == chosen || std::find(known.begin(), known.end(), i) != known.end()) return;
    cause.equivalent.push_back(i);
    with_equals += cause.ranking[i].probability;
  };
  for (std::size_t i = 0; i < cause.ranking.size(); ++i)
    if (near(best, cause.ranking[i].hypothesis)) list(i);
  for (const std::size_t i : told_by_tolerances(cause, chosen)) list(i);
  // Less than half together are not named without the next, nor is one alone of which the others are too
  // much.
  const auto enough = [&] {
    return with_equals >= 0.5 &&
           (!cause.equivalent.empty() || with_equals >= beliefs::named_alone * (1 - unknown));
  };
  for (std::size_t i = 0; i < cause.ranking.size() && !enough(); ++i) list(i);
  cause.verdict = cause.equivalent.empty() ? CauseVerdict::identified : CauseVerdict::ambiguous;
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
