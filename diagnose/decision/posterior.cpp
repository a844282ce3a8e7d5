#include "diagnose/decision/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <plumbline/base/parallel.hpp>

#include "diagnose/decision/local_departure.hpp"
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

double log_sum_of(const std::vector<double>& terms) {
  return log_sum(Eigen::Map<const VectorXd>(terms.data(), static_cast<Eigen::Index>(terms.size())));
}

/// Logarithm of the probability that the readings that scatter more than others, by these factors, do so by
/// noise: any order of magnitude up to two is as probable where a cause outside the catalogue scatters them.
double log_noise_alone(const std::vector<NoisierSegment>& noisier) {
  const double cause = std::log((1 - priors::no_gap) * priors::outside * priors::nugget / priors::no_gap) -
                       std::log(std::log(100.0));
  constexpr double student = 0.375;  // density of four degrees of freedom at zero
  double sum = 0;
  for (const NoisierSegment& one : noisier) {
    const double noise =
        log_scale_prior(std::log(one.factor)) + std::log(student / priors::noise_scale_spread);
    sum -= std::log1p(std::exp(cause - noise));
  }
  return sum;
}

/// One way in which the readings may have come about.
struct Weight {
  double log_weight;
  enum class Of { nothing, listed, outside } of;
  bool exact;              ///< nothing is left beside it
  std::size_t hypothesis;  ///< of a listed cause
};

class Weights {
 public:
  Weights(const Study& study, const Findings& findings)
      : found_(findings), priors_(findings.likelihood->priors()) {
    const Decomposition nominal = findings.likelihood->decompose(study.nominal_residual());
    log_local_ = log_local_departure(
        study.measurements(), study.nominal_residual() - nominal.delta - nominal.periodic, nominal.noise);
    const NoiseShape& shape = findings.likelihood->shape();
    log_noise_ = log_noise_alone(shape.noisier);
    // With every autocorrelation: the search has left out those that do not matter beside its best cause.
    log_step_ =
        Likelihood(study.measurements(), *findings.states, noise_alone(), shape, study.nominal_residual())
            .log_step(study.nominal_residual());
    const std::size_t count = findings.hypotheses.size();
    log_odds_.assign(count, 0.0);
    in_parallel(count, study.threads(), [&](std::size_t i) {
      const Hypothesis& one = findings.hypotheses[i];
      if (has_outside(one.candidate) && !labels_of(one.candidate).empty())
        log_odds_[i] = log_odds_of_listed(discrepancy_share(study, findings, one));
    });
  }

  /// Where the likelihood counts to this power.
  [[nodiscard]] std::vector<Weight> at(double temper) const {
    using Of = Weight::Of;
    const double nothing = std::log(priors::no_gap) + temper * found_.nominal.log_by_amplitude.front();
    std::vector<Weight> all{{nothing + log_noise_, Of::nothing, true, 0},
                            {nothing + std::log(-std::expm1(log_noise_)), Of::outside, true, 0}};
    add_outside(all, temper);
    for (std::size_t i = 0; i < found_.hypotheses.size(); ++i) {
      const Hypothesis& one = found_.hypotheses[i];
      const std::vector<double>& likelihood = one.look.log_by_amplitude;
      const double base = std::log(1 - priors::no_gap) + one.log_prior + one.volume.log_at(temper);
      if (!has_outside(one.candidate)) {
        add(all, base + std::log(1 - priors::outside), likelihood, temper, priors_.log_amplitude,
            {Of::listed, i});
        add(all, base + std::log(priors::outside), likelihood, temper, priors_.log_amplitude_outside,
            {Of::outside, i});
        split(all, base + std::log(priors::nugget) + temper * one.look.log_nugget,
              log_odds_of_listed(one.look.nugget_size), true, i);
        continue;
      }
      std::vector<double> terms;
      for (std::size_t a = 0; a < likelihood.size(); ++a)
        terms.push_back(temper * likelihood[a] + priors_.log_amplitude[a]);
      const double weight = base + log_sum_of(terms);
      if (labels_of(one.candidate).empty())
        all.push_back({weight, Of::outside, false, i});
      else
        split(all, weight, log_odds_[i], false, i);
    }
    const double sum = log_total(all);
    for (Weight& one : all) one.log_weight -= sum;
    return all;
  }

 private:
  /// The nominal model beside a cause outside the catalogue, of each kind.
  void add_outside(std::vector<Weight>& all, double temper) const {
    const Look& nominal = found_.nominal;
    const double outside = std::log((1 - priors::no_gap) * priors::outside);
    const auto add_kind = [&](double share, double log_likelihood, bool exact) {
      all.push_back({outside + std::log(share) + temper * log_likelihood, Weight::Of::outside, exact, 0});
    };
    constexpr double kinds = priors::local + priors::nugget + priors::step + priors::one_channel;
    add(all, outside + std::log(1 - kinds), nominal.log_by_amplitude, temper, priors_.log_amplitude_outside,
        {Weight::Of::outside, 0});
    add_kind(priors::one_channel, nominal.log_one_channel, false);
    add_kind(priors::local, nominal.log_by_amplitude.front() + log_local_, true);
    add_kind(priors::nugget, nominal.log_nugget, true);
    add_kind(priors::step, log_step_, true);
  }

  /// Of a cause in the catalogue over one outside, where so much of the nominal residual is left to what the
  /// catalogue does not have.
  [[nodiscard]] double log_odds_of_listed(double size) const {
    return priors_.log_odds_of_listed(std::max(1e-3, size)) +
           std::log((1 - priors::outside) / priors::outside);
  }

  /// A hypothesis of a cause in the catalogue and of one outside.
  static void split(std::vector<Weight>& all, double weight, double log_odds, bool exact, std::size_t of) {
    all.push_back({weight - std::log1p(std::exp(log_odds)), Weight::Of::outside, exact, of});
    all.push_back({weight - std::log1p(std::exp(-log_odds)), Weight::Of::listed, exact, of});
  }

  /// A hypothesis with nothing left, and with a discrepancy of any size.
  static void add(std::vector<Weight>& all, double base, const std::vector<double>& likelihood, double temper,
                  const std::vector<double>& prior, std::pair<Weight::Of, std::size_t> of) {
    std::vector<double> terms;
    for (std::size_t a = 0; a < likelihood.size(); ++a) terms.push_back(temper * likelihood[a] + prior[a]);
    all.push_back({base + terms.front(), of.first, true, of.second});
    all.push_back({base + log_sum_of({terms.begin() + 1, terms.end()}), of.first, false, of.second});
  }

  static double log_total(const std::vector<Weight>& all) {
    std::vector<double> terms;
    for (const Weight& one : all) terms.push_back(one.log_weight);
    return log_sum_of(terms);
  }

  const Findings& found_;
  const Hyperpriors& priors_;
  double log_local_ = 0;          ///< of a local departure from the nominal model, over none
  double log_noise_ = 0;          ///< logarithm of the probability that what scatters more is noise
  double log_step_ = 0;           ///< log likelihood of a step beside the nominal model
  std::vector<double> log_odds_;  ///< by hypothesis beside an unknown torque: of being listed
};

}  // namespace

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

Posterior posterior(const Study& study, const Findings& findings) {
  const Weights weights(study, findings);
  Posterior result;
  result.exact = 0;
  for (const Weight& one : weights.at(1))
    if (one.exact) result.exact += std::exp(one.log_weight);
  result.temper = result.exact + (1 - result.exact) * priors::temper;
  std::map<Labels, CauseProbability> causes;
  for (const Weight& one : weights.at(result.temper)) {
    const double p = std::exp(one.log_weight);
    if (one.of == Weight::Of::nothing) result.no_gap += p;
    if (one.of == Weight::Of::outside) result.outside += p;
    if (one.of != Weight::Of::listed) continue;
    const Labels labels = labels_of(findings.hypotheses[one.hypothesis].candidate);
    // Hypotheses stand in the order of their evidence: the first form is the most probable.
    causes.try_emplace(labels, CauseProbability{labels, 0, one.hypothesis}).first->second.probability += p;
  }
  for (auto& [labels, cause] : causes) {
    cause.probability = std::min(1.0, cause.probability);  // but for rounding
    result.causes.push_back(std::move(cause));
  }
  std::stable_sort(
      result.causes.begin(), result.causes.end(),
      [](const CauseProbability& a, const CauseProbability& b) { return a.probability > b.probability; });
  return result;
}

}  // namespace plumbline::diagnose
