#include "diagnose/decision/alike.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "diagnose/beliefs.hpp"
#include "diagnose/decision/rival.hpp"

namespace plumbline::diagnose {
namespace {

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
  const bool machining_alone = best.fit.candidate.has_all_tolerances() && best.fit.candidate.count() == 1;
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

}  // namespace

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

}  // namespace plumbline::diagnose
