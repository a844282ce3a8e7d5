#include "diagnose/search.hpp"

#include <algorithm>

#include "diagnose/promise.hpp"
#include "diagnose/start.hpp"

namespace plumbline {
namespace {

bool better(const Fit& a, const Fit& b) {
  return a.cost < b.cost;
}

/// How far a search goes. A second effect is looked for beside the fifteen best effects alone: of two causes
/// one is among them unless both hide behind more than a dozen that mimic their sum. A third is looked for
/// beside the eight best pairs. The twenty that promise most are fitted.
constexpr std::size_t single_seeds = 15, pair_seeds = 8, finalists = 20;

class Searcher {
 public:
  Searcher(const Experiment& experiment, const Measurements& measurements)
      : experiment_(experiment), measurements_(measurements), nominal_(predict(experiment, {}, {})) {}

  [[nodiscard]] std::vector<Fit> singles() {
    for (const EffectAt& at : possible_effects(experiment_))
      keep(alone_, fit(experiment_, measurements_, Candidate{{at}}, {}));
    std::vector<Fit> fits = alone_;
    std::sort(fits.begin(), fits.end(), better);
    return fits;
  }

  /// Adds one more effect to each of the best so far.
  [[nodiscard]] std::vector<Fit> extended(const std::vector<Fit>& from, std::size_t seeds) const {
    std::vector<Promise> promises;
    for (std::size_t s = 0; s < std::min(seeds, from.size()); ++s) {
      for (const Fit& newcomer : alone_) {
        if (holds(promises, from[s].candidate, newcomer)) continue;
        const std::optional<Promise> one = promise(experiment_, measurements_, from[s], newcomer,
                                                   first_start(newcomer.candidate.effects.front()), {});
        if (one) promises.push_back(*one);
      }
    }
    std::sort(promises.begin(), promises.end(),
              [](const Promise& a, const Promise& b) { return a.cost < b.cost; });
    std::vector<Fit> fits;
    for (std::size_t p = 0; p < std::min(finalists, promises.size()); ++p)
      keep(fits, fit_from(experiment_, measurements_, promises[p].candidate, {}, promises[p].start));
    std::sort(fits.begin(), fits.end(), better);
    return fits;
  }

 private:
  static void keep(std::vector<Fit>& fits, Fit one) {
    if (one.converged) fits.push_back(std::move(one));
  }

  /// Whether the effect is there already, or the combination has been tried from another side.
  static bool holds(const std::vector<Promise>& promises, const Candidate& base, const Fit& newcomer) {
    std::vector<EffectAt> effects = base.effects;
    const EffectAt at = newcomer.candidate.effects.front();
    if (std::count(effects.begin(), effects.end(), at) > 0) return true;
    effects.push_back(at);
    return std::any_of(promises.begin(), promises.end(), [&](const Promise& one) {
      return std::is_permutation(one.candidate.effects.begin(), one.candidate.effects.end(), effects.begin(),
                                 effects.end());
    });
  }

  std::vector<double> first_start(const EffectAt& at) const {
    return starts(experiment_, nominal_, at).from.front();
  }

  const Experiment& experiment_;
  const Measurements& measurements_;
  Prediction nominal_;
  std::vector<Fit> alone_;  ///< every effect by itself
};

}  // namespace

void weigh(const Experiment& experiment, const Measurements& measurements, Findings& findings) {
  auto& hypotheses = findings.hypotheses;
  if (hypotheses.empty()) return;
  const auto best = std::min_element(hypotheses.begin(), hypotheses.end(),
                                     [](const auto& a, const auto& b) { return better(a.fit, b.fit); });
  findings.noise = estimate_noise(measurements, without_outliers(measurements, best->fit.residual));
  for (Hypothesis& hypothesis : hypotheses) {
    hypothesis.log_likelihood = log_likelihood(measurements, hypothesis.fit.residual, findings.noise);
    hypothesis.log_evidence = log_evidence(experiment, measurements, hypothesis.fit, findings.noise);
  }
  std::sort(hypotheses.begin(), hypotheses.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.log_evidence > b.log_evidence; });
}

Findings search(const Experiment& experiment, const Measurements& measurements,
                const std::function<void(double)>& progress) {
  const auto report = [&](double share) {
    if (progress) progress(share);
  };
  Searcher searcher(experiment, measurements);
  std::vector<Fit> fits = searcher.singles();
  const auto p_value = [&] { return test_gap(measurements, fits.front().residual).p_value; };
  const auto add = [&](const std::vector<Fit>& more) {
    fits.insert(fits.end(), more.begin(), more.end());
    std::sort(fits.begin(), fits.end(), better);
  };
  report(0.1);
  if (!fits.empty() && p_value() < gap_level) {
    const std::vector<Fit> pairs = searcher.extended(fits, single_seeds);
    add(pairs);
    report(0.5);
    if (p_value() < fit_level) add(searcher.extended(pairs, pair_seeds));
  }
  Findings findings;
  for (Fit& one : fits) findings.hypotheses.push_back({std::move(one), 0, 0, 1});
  weigh(experiment, measurements, findings);
  report(1);
  return findings;
}

}  // namespace plumbline
