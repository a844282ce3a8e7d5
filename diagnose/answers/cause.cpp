#include "diagnose/answers/cause.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/answers/discrepancy_torque.hpp"

namespace plumbline::diagnose {
namespace {

/// The hypothesis without unknown torques.
Hypothesis listed_part(const Study& study, const Findings& findings, const Hypothesis& found) {
  const auto is_listed = [](const EffectAt& at) { return !at.effect->outside; };
  if (std::all_of(found.candidate.effects.begin(), found.candidate.effects.end(), is_listed)) return found;
  const Instance listed = part(study, found.candidate, found.parameters, is_listed);
  return maximised(study, *findings.likelihood, listed.candidate, listed.parameters, {4, 0.03});
}

Candidate cause_of(const Candidate& candidate) {
  Candidate cause;
  for (const EffectAt& at : candidate.effects)
    if (!candidate.has_as_tolerance(at)) cause.effects.push_back(at);
  return cause.effects.empty() ? candidate : cause;
}

std::vector<EffectProbability> by_effect(const Posterior& posterior) {
  constexpr double negligible = 0.01;
  std::vector<EffectProbability> effects;
  for (const auto& [label, probability] : posterior.effects)
    if (probability >= negligible) effects.push_back({label, probability});
  std::stable_sort(
      effects.begin(), effects.end(),
      [](const EffectProbability& a, const EffectProbability& b) { return a.probability > b.probability; });
  return effects;
}

/// Whether it is more probable than not that the hypothesis leaves a discrepancy.
bool leaves_discrepancy(const Findings& findings, const Hypothesis& lead) {
  const std::vector<double> posterior =
      log_posterior(lead.look.log_by_amplitude, findings.likelihood->priors().log_amplitude);
  return std::exp(posterior.front()) < 0.5;
}

}  // namespace

double chi2_per_value(const Study& study, const NoiseEstimate& noise, const VectorXd& residual) {
  const VectorXd sigma = noise.sigma(study.measurements());
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < noise.shape.outlier.size(); ++i)
    if (!noise.shape.outlier[i])
      sum += std::pow(residual(static_cast<Eigen::Index>(i)) / sigma(static_cast<Eigen::Index>(i)), 2),
          count += 1;
  return count > 0 ? sum / count : 1;
}

Cause judge(const Study& study, const Findings& findings, const Posterior& posterior,
            const NoiseEstimate& noise) {
  constexpr std::size_t listed = 10;
  const Verdict verdict = decide(posterior);
  Cause cause;
  cause.verdict = verdict.verdict;
  cause.or_unknown = verdict.or_outside && verdict.verdict == CauseVerdict::ambiguous;
  cause.too_few_readings = verdict.too_few_readings;
  cause.unknown = posterior.outside;
  cause.effects = by_effect(posterior);
  const std::size_t most = std::max(verdict.named, listed);
  for (const CauseProbability& one : posterior.causes) {
    if (cause.ranking.size() == most) break;
    Hypothesis form = listed_part(study, findings, findings.hypotheses[one.hypothesis]);
    if (!form.converged) continue;
    const double chi2 = chi2_per_value(study, noise, form.residual);
    Candidate effects = cause_of(form.candidate);
    cause.ranking.push_back({std::move(form), std::move(effects), one.probability, chi2});
  }
  cause.named = std::min(verdict.named, cause.ranking.size());
  if (cause.ranking.empty() || verdict.verdict == CauseVerdict::none) return cause;
  const Hypothesis& lead = cause.ranking.front().hypothesis;
  if (!leaves_discrepancy(findings, lead)) return cause;
  cause.discrepancy = discrepancy_share(study, findings, lead);
  if (!study.experiment().has_links()) cause.torque_unit = study.experiment().torque_unit(0);
  cause.discrepancy_torque =
      discrepancy_torque(study, lead, findings.likelihood->decompose(lead.residual).delta);
  return cause;
}

}  // namespace plumbline::diagnose
