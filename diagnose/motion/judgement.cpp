#include "diagnose/motion/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <map>

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

/// All that a hypothesis leaves of the means, in standard deviations of the readings' noise.
Eigen::VectorXd in_sigmas(const Study& study, const Hypothesis& h) {
  std::vector<double> all;
  for (const SegmentMeans& one : study.left(h.parameters, h.values, h.begins))
    for (Eigen::Index i = 0; i < one.residual.size(); ++i)
      all.push_back(one.residual(i) / std::sqrt(one.variance(i)));
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// The smallest part of a cause that changes the logs nearly as all of it does: what it leaves of that
/// change, root mean squares, costs less than one name more. The cause itself where it has no such part.
class MainCauses {
 public:
  MainCauses(const Study& study, const Findings& findings) : study_(study), findings_(findings) {}

  std::size_t operator()(std::size_t whole) {
    const std::vector<std::string> labels = labels_of(findings_.hypotheses[whole].candidate);
    if (labels.size() < 2) return whole;
    const double changed = (residual(findings_.nominal) - residual(findings_.hypotheses[whole])).norm();
    std::size_t best = whole, fewest = labels.size();
    for (std::size_t i = 0; i < findings_.hypotheses.size(); ++i) {
      const std::vector<std::string> some = labels_of(findings_.hypotheses[i].candidate);
      if (some.size() >= fewest || !std::includes(labels.begin(), labels.end(), some.begin(), some.end()))
        continue;
      const double left = (residual(findings_.hypotheses[i]) - residual(findings_.hypotheses[whole])).norm();
      if (diagnose::priors::wrong_over_further_name * left < changed) best = i, fewest = some.size();
    }
    return best;
  }

 private:
  /// Predicted once for each hypothesis.
  const Eigen::VectorXd& residual(const Hypothesis& of) {
    const auto found = residual_.find(&of);
    if (found != residual_.end()) return found->second;
    return residual_[&of] = in_sigmas(study_, of);
  }

  const Study& study_;
  const Findings& findings_;
  std::map<const Hypothesis*, Eigen::VectorXd> residual_;
};

}  // namespace

Posterior posterior(const Study& study, const Findings& findings) {
  const std::vector<Way> all = ways(findings), gaps(all.begin() + 1, all.end());
  const diagnose::Weighed weighed = diagnose::weigh(all);
  Posterior result;
  static_cast<diagnose::GapPosterior&>(result) = weighed.gap;
  double most = 0;
  constexpr double least_named = 1e-3;  // causes that are less probable are not named
  MainCauses main_cause(study, findings);
  std::map<std::size_t, double> listed;  // by hypothesis
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double p = weighed.probability[i];
    if (gaps[i].of == Way::Of::outside) result.outside += p;
    if (gaps[i].hypothesis == Way::none) continue;
    const std::vector<std::string> labels = labels_of(findings.hypotheses[gaps[i].hypothesis].candidate);
    for (const std::string& label : labels) result.effects[label] += p;
    if (p > most) most = p, result.leading = gaps[i].hypothesis;
    if (gaps[i].of == Way::Of::listed)
      listed[p > least_named ? main_cause(gaps[i].hypothesis) : gaps[i].hypothesis] += p;
  }
  for (const auto& [hypothesis, p] : listed)
    result.causes.push_back(
        {labels_of(findings.hypotheses[hypothesis].candidate), std::min(1.0, p), hypothesis});
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
