#include "diagnose/motion/judgement.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/inference/size_prior.hpp"
#include "diagnose/log_sum.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::motion {
namespace {

using diagnose::Posterior, diagnose::Way, diagnose::log_sum, diagnose::sum;

std::vector<std::string> labels_of(const Candidate& candidate) {
  std::vector<std::string> labels;
  for (const Row* row : candidate.rows) labels.emplace_back(row->id);
  std::sort(labels.begin(), labels.end());
  return labels;
}

/// Probability that a discrepancy is there, at sizes with this prior.
double share_of_discrepancy(const Look& look, const std::vector<double>& log_amplitude) {
  return 1 - std::exp(diagnose::log_posterior(look.log_by_amplitude, log_amplitude).front());
}

/// Every way in which the logs may have come about: noise alone, a cause outside, and each hypothesis with a
/// little beside it, or as what a cause outside is imitated by.
std::vector<Way> ways(const Findings& findings) {
  const diagnose::Hyperpriors& priors = findings.likelihood->priors();
  const double gap = std::log(1 - diagnose::priors::no_gap), out = std::log(diagnose::priors::outside),
               in = std::log(1 - diagnose::priors::outside);
  const Look& nominal = findings.nominal.look;
  std::vector<Way> all{
      {Way::Of::nothing, Way::none, std::log(diagnose::priors::no_gap), nominal.log_by_amplitude.front(), 0},
      {Way::Of::outside, Way::none, gap + out,
       log_sum(sum(nominal.log_by_amplitude, priors.log_amplitude_outside)), 1}};
  for (std::size_t i = 0; i < findings.hypotheses.size(); ++i) {
    const Hypothesis& one = findings.hypotheses[i];
    const auto add = [&](Way::Of of, double log_share, const std::vector<double>& log_amplitude) {
      all.push_back({of, i, gap + one.log_prior + log_share,
                     one.log_volume + log_sum(sum(one.look.log_by_amplitude, log_amplitude)),
                     share_of_discrepancy(one.look, log_amplitude)});
    };
    add(Way::Of::listed, in, priors.log_amplitude);
    add(Way::Of::outside, out, diagnose::log_amplitude_imitated(priors));
  }
  return all;
}

}  // namespace

Posterior posterior(const Findings& findings) {
  const std::vector<Way> all = ways(findings), gaps(all.begin() + 1, all.end());
  const diagnose::Weighed weighed = diagnose::weigh(all);
  Posterior result;
  static_cast<diagnose::GapPosterior&>(result) = weighed.gap;
  double most = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double p = weighed.probability[i];
    if (gaps[i].of == Way::Of::outside) result.outside += p;
    if (gaps[i].hypothesis == Way::none) continue;
    const std::vector<std::string> labels = labels_of(findings.hypotheses[gaps[i].hypothesis].candidate);
    for (const std::string& label : labels) result.effects[label] += p;
    if (p > most) most = p, result.leading = gaps[i].hypothesis;
    if (gaps[i].of == Way::Of::listed)
      result.causes.push_back({labels, std::min(1.0, p), gaps[i].hypothesis});
  }
  std::stable_sort(result.causes.begin(), result.causes.end(),
                   [](const auto& a, const auto& b) { return a.probability > b.probability; });
  if (!result.causes.empty()) {
    const Hypothesis& first = findings.hypotheses[result.causes.front().hypothesis];
    result.leaves_nothing =
        share_of_discrepancy(first.look, findings.likelihood->priors().log_amplitude) < 0.5;
  }
  return result;
}

}  // namespace plumbline::motion
