#include "diagnose/decision/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <plumbline/base/parallel.hpp>

#include "diagnose/inference/fitted_volume.hpp"
#include "diagnose/inference/prior.hpp"
#include "diagnose/inference/size_prior.hpp"
#include "diagnose/outside/outside_cause.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

using Labels = std::vector<std::string>;

bool has_outside(const Candidate& candidate) {
  return std::any_of(candidate.effects.begin(), candidate.effects.end(),
                     [](const EffectAt& at) { return at.effect->outside; });
}

/// The cause of the catalogue that a candidate is a form of; nothing for unknown torques alone.
Labels labels_of(const Candidate& candidate) {
  Labels labels, tolerances;
  for (const EffectAt& at : candidate.effects)
    if (!at.effect->outside) (candidate.has_as_tolerance(at) ? tolerances : labels).push_back(at.label());
  if (labels.empty()) labels = tolerances;
  std::sort(labels.begin(), labels.end());
  return labels;
}

/// A probability that changes no answer.
constexpr double negligible = 1e-6;

bool is_tolerances_alone(const Candidate& candidate) {
  return std::all_of(candidate.effects.begin(), candidate.effects.end(), [&](const EffectAt& at) {
    return at.effect->outside || candidate.has_as_tolerance(at);
  });
}

/// Log odds of a cause in the catalogue over one outside, where so much of the nominal residual is left to
/// what the catalogue does not have.
double log_odds_of_listed(const Hyperpriors& priors, double size) {
  return priors.log_odds_of_listed(std::max(1e-3, size)) + std::log((1 - priors::outside) / priors::outside);
}

/// A hypothesis of a cause in the catalogue and of one outside.
void split(std::vector<Way>& all, Way way, double log_odds) {
  const double log_prior = way.log_prior;
  way.of = Way::Of::outside, way.log_prior = log_prior - std::log1p(std::exp(log_odds));
  all.push_back(way);
  way.of = Way::Of::listed, way.log_prior = log_prior - std::log1p(std::exp(-log_odds));
  all.push_back(way);
}

/// A hypothesis of effects of the catalogue alone: with a little beside them, beside a cause outside that
/// they imitate, and beside scatter.
void add_listed(std::vector<Way>& all, const Findings& findings, std::size_t i, double log_prior) {
  const Hyperpriors& priors = findings.likelihood->priors();
  const Hypothesis& one = findings.hypotheses[i];
  const double volume = one.log_volume;
  const auto add = [&](Way::Of of, double share, const std::vector<double>& log_amplitude) {
    all.push_back({of, i, log_prior + std::log(share),
                   volume + log_sum(sum(one.look.log_by_amplitude, log_amplitude)),
                   expected(one.look.log_by_amplitude, log_amplitude, one.look.discrepancy)});
  };
  add(Way::Of::listed, 1 - priors::outside, priors.log_amplitude);
  add(Way::Of::outside, priors::outside, log_amplitude_imitated(priors));
  for (const OutsideRow& row : outside_rows) {
    const std::unique_ptr<OutsideCause> kind = row.make();
    if (!kind->stands_beside()) continue;
    const OutsideFit fit = kind->fit({*findings.likelihood, one.residual, one.look});
    split(all, {{}, i, log_prior + std::log(priors::scatter_beside), volume + fit.log_likelihood, 0},
          log_odds_of_listed(priors, fit.size));
  }
}

/// The same beside an unknown torque, of the size that it has, and a little more.
void add_beside_torque(std::vector<Way>& all, const Study& study, const Findings& findings, std::size_t i,
                       double log_prior) {
  const Hyperpriors& priors = findings.likelihood->priors();
  const Hypothesis& one = findings.hypotheses[i];
  const double left = expected(one.look.log_by_amplitude, priors.log_amplitude, one.look.discrepancy);
  const Way way{Way::Of::outside, i, log_prior, one.log_volume + one.look.log_likelihood, left};
  if (labels_of(one.candidate).empty())
    all.push_back(way);
  else
    split(all, way, log_odds_of_listed(priors, discrepancy_share(study, findings, one)));
}

/// Whether a hypothesis has an effect that the bench cannot test: such a cause is none that could be named.
bool is_untimed(const Findings& findings, const Hypothesis& one) {
  return std::any_of(findings.untimed.begin(), findings.untimed.end(),
                     [&](const EffectAt& at) { return one.candidate.has(at); });
}

/// Whether nothing but noise, at most as much over the declared one as a scatter that is no noise, is
/// probably left beside a hypothesis. A marked reading is off by no more than outliers are.
bool leaves_nothing(const Findings& findings, const Hypothesis& one) {
  const std::vector<bool>& outlier = findings.likelihood->shape().outlier;
  double sum = 0;
  for (std::size_t i = 0; i < outlier.size(); ++i) {
    const double z = std::abs(one.residual(static_cast<Eigen::Index>(i)));
    sum += std::pow(outlier[i] ? std::min(z, priors::outlier_width) : z, 2);
  }
  const std::vector<double> size =
      log_posterior(one.look.log_by_amplitude, findings.likelihood->priors().log_amplitude);
  return std::exp(size.front()) > 0.5 &&
         sum <= priors::scatter * priors::scatter * static_cast<double>(outlier.size());
}

/// The effects of a hypothesis, and its probability.
struct Holding {
  Labels labels;
  double probability;
};

/// Effects of which one at least is part of the cause, and the probability of that.
struct Cover {
  Labels labels = {};
  double probability = 0;
};

/// The most probable of all covers that have so many effects more.
Cover most_probable(const std::vector<Holding>& left, const Labels& effects, const Cover& cover,
                    std::size_t more) {
  if (more == 0) return cover;
  Cover best;
  for (auto at = effects.begin(); at != effects.end(); ++at) {
    Cover wider = cover;
    wider.labels.push_back(*at);
    std::vector<Holding> others;
    for (const Holding& one : left)
      if (std::find(one.labels.begin(), one.labels.end(), *at) != one.labels.end())
        wider.probability += one.probability;
      else
        others.push_back(one);
    wider = most_probable(others, Labels(std::next(at), effects.end()), wider, more - 1);
    if (wider.probability > best.probability) best = std::move(wider);
  }
  return best;
}

/// Posterior::surely_part: each effect more has to be worth naming.
/// \param effects  with their probabilities
Labels surely_part(const std::vector<Holding>& all, const std::map<std::string, double>& effects) {
  constexpr std::size_t most = 3;
  Labels worth_naming;
  for (const auto& [label, probability] : effects)
    if (probability * priors::wrong_over_further_name >= 1) worth_naming.push_back(label);
  Cover cover;
  while (cover.probability < priors::part_of_it) {
    Cover wider = most_probable(all, worth_naming, {}, cover.labels.size() + 1);
    if ((wider.probability - cover.probability) * priors::wrong_over_further_name < 1 ||
        wider.labels.size() > most)
      return {};
    cover = std::move(wider);
  }
  std::stable_sort(cover.labels.begin(), cover.labels.end(),
                   [&](const std::string& a, const std::string& b) { return effects.at(a) > effects.at(b); });
  return cover.labels;
}

using Causes = std::map<Labels, CauseProbability>;

/// Where the readings do not speak for an effect of a hypothesis, its cause is that of the others.
/// \param p  probability of the hypothesis as a cause of the catalogue
void move_to_what_is_seen(const Study& study, const Hypothesis& hypothesis, double p, Causes& causes) {
  const Labels labels = labels_of(hypothesis.candidate);
  if (labels.size() < 2 || p < negligible) return;
  for (const SeenEffects& one : seen_effects(study, hypothesis)) {
    const auto seen = causes.find(labels_of(one.candidate));
    if (seen == causes.end()) continue;
    causes.at(labels).probability -= p * one.share;
    seen->second.probability += p * one.share;
  }
}

/// The root mean square of what is left of a cause where a part of it is taken for all of it, over that of
/// what the cause changes in the readings; one at most.
double share_left(const Study& study, const Findings& findings, const CauseProbability& cause,
                  const CauseProbability& taken) {
  if (!std::includes(cause.labels.begin(), cause.labels.end(), taken.labels.begin(), taken.labels.end()))
    return 1;
  const VectorXd& whole = findings.hypotheses[cause.hypothesis].residual;
  const VectorXd change = study.nominal_residual() - whole,
                 left = findings.hypotheses[taken.hypothesis].residual - whole;
  const std::vector<bool>& outlier = findings.likelihood->shape().outlier;
  double changed = 0, not_taken = 0;
  for (Eigen::Index i = 0; i < change.size(); ++i)
    if (!outlier[static_cast<std::size_t>(i)])
      changed += change(i) * change(i), not_taken += left(i) * left(i);
  return not_taken < changed ? std::sqrt(not_taken / changed) : 1;
}

/// Logarithms of the probabilities of all ways, where the evidence counts to a power.
std::vector<double> log_weights(const std::vector<Way>& all, double power) {
  std::vector<double> weight;
  for (const Way& one : all) weight.push_back(one.log_prior + power * one.log_evidence);
  const double sum = log_sum(weight);
  for (double& one : weight) one -= sum;
  return weight;
}

}  // namespace

Weighed weigh(const std::vector<Way>& all) {
  const std::vector<Way> gaps(all.begin() + 1, all.end());
  const std::vector<double> log_probability = log_weights(all, 1), plain = log_weights(gaps, 1);
  const std::vector<double> of_gaps(log_probability.begin() + 1, log_probability.end());
  Weighed result;
  result.gap.no_gap = std::exp(log_probability.front());
  result.gap.log_odds_of_gap = log_sum(of_gaps) - log_probability.front();
  double discrepancy = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].log_evidence > all.front().log_evidence) result.gap.seen_gap += std::exp(of_gaps[i]);
    discrepancy += std::exp(plain[i]) * gaps[i].discrepancy;
  }
  result.gap.temper = 1 - discrepancy * (1 - priors::temper);
  for (const double weight : log_weights(gaps, result.gap.temper))
    result.probability.push_back((1 - result.gap.no_gap) * std::exp(weight));
  return result;
}

double discrepancy_share(const Study& study, const Findings& findings, const Hypothesis& hypothesis) {
  VectorXd left = findings.likelihood->decompose(hypothesis.residual).delta;
  if (has_outside(hypothesis.candidate)) {
    const Instance listed = part(study, hypothesis.candidate, hypothesis.parameters,
                                 [](const EffectAt& at) { return !at.effect->outside; });
    const Prediction predicted = predict(study, listed.candidate, listed.parameters);
    if (predicted.reached) left += study.residual(predicted) - hypothesis.residual;
  }
  const VectorXd nominal = study.nominal_residual();
  const std::vector<bool>& outlier = findings.likelihood->shape().outlier;
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < outlier.size(); ++i) {
    if (outlier[i]) continue;
    const auto k = static_cast<Eigen::Index>(i);
    sum += left(k) * left(k), all += nominal(k) * nominal(k);
  }
  return all > 0 ? std::sqrt(sum / all) : 0;
}

std::vector<Way> ways(const Study& study, const Findings& findings) {
  const Look& nominal = findings.nominal;
  std::vector<Way> all{
      {Way::Of::nothing, Way::none, std::log(priors::no_gap), nominal.log_by_amplitude.front(), 0}};
  const VectorXd residual = study.nominal_residual();
  const double gap = std::log(1 - priors::no_gap),
               outside = priors::outside + (1 - priors::outside) * untested_share(study);
  for (const OutsideRow& row : outside_rows) {
    const OutsideFit fit = row.make()->fit({*findings.likelihood, residual, nominal});
    all.push_back({Way::Of::outside, Way::none, gap + std::log(outside * row.share), fit.log_likelihood,
                   fit.discrepancy});
  }
  std::vector<std::vector<Way>> of(findings.hypotheses.size());
  in_parallel(of.size(), study.threads(), [&](std::size_t i) {
    const Hypothesis& one = findings.hypotheses[i];
    if (has_outside(one.candidate))
      add_beside_torque(of[i], study, findings, i, gap + one.log_prior);
    else
      add_listed(of[i], findings, i, gap + one.log_prior);
    if (is_untimed(findings, one))
      for (Way& way : of[i]) way.of = Way::Of::outside, way.hypothesis = Way::none;
  });
  for (const std::vector<Way>& some : of) all.insert(all.end(), some.begin(), some.end());
  return all;
}

Posterior posterior(const Study& study, const Findings& findings) {
  const std::vector<Way> all = ways(study, findings), gaps(all.begin() + 1, all.end());
  const Weighed weighed = weigh(all);
  Posterior result;
  static_cast<GapPosterior&>(result) = weighed.gap;
  Causes causes;
  std::vector<Holding> holding;
  double most = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double p = weighed.probability[i];
    if (gaps[i].of == Way::Of::outside) result.outside += p;
    if (gaps[i].hypothesis == Way::none) continue;
    const Candidate& candidate = findings.hypotheses[gaps[i].hypothesis].candidate;
    const Labels labels = labels_of(candidate);
    if (!is_tolerances_alone(candidate)) holding.push_back({labels, p});
    for (const std::string& label : labels) result.effects[label] += p;
    if (!labels.empty() && p > most) most = p, result.leading = gaps[i].hypothesis;
    // Hypotheses stand in the order of their evidence: the first form is the most probable.
    if (gaps[i].of == Way::Of::listed)
      causes.try_emplace(labels, CauseProbability{labels, 0, gaps[i].hypothesis}).first->second.probability +=
          p;
  }
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (gaps[i].of == Way::Of::listed)
      move_to_what_is_seen(study, findings.hypotheses[gaps[i].hypothesis], weighed.probability[i], causes);
  result.surely_part = surely_part(holding, result.effects);
  for (auto& [label, probability] : result.effects) probability = std::min(1.0, probability);  // likewise
  for (auto& [labels, cause] : causes) {
    cause.probability = std::clamp(cause.probability, 0.0, 1.0);  // but for rounding
    result.causes.push_back(std::move(cause));
  }
  std::stable_sort(
      result.causes.begin(), result.causes.end(),
      [](const CauseProbability& a, const CauseProbability& b) { return a.probability > b.probability; });
  for (std::size_t i = 1; i < result.causes.size() && result.causes[i].probability > negligible; ++i)
    for (std::size_t k = 0; k < std::min(i, priors::largest_class); ++k)
      result.causes[i].left.push_back(share_left(study, findings, result.causes[i], result.causes[k]));
  if (!result.causes.empty())
    result.leaves_nothing = leaves_nothing(findings, findings.hypotheses[result.causes.front().hypothesis]);
  return result;
}

}  // namespace plumbline::diagnose
