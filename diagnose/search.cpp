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

Findings search(const Experiment& experiment, const Measurements& measurements,
                const std::function<void(double)>& progress) {
  Searcher searcher(experiment, measurements);
  std::vector<Fit> fits = searcher.singles();
  if (progress) progress(0.1);
  const auto structure = [&] { return test_gap(measurements, fits.front().residual); };
  GapTest test = structure();
  if (test.p_value < gap_level) {
    const std::vector<Fit> pairs = searcher.extended(fits, single_seeds);
    fits.insert(fits.end(), pairs.begin(), pairs.end());
    std::sort(fits.begin(), fits.end(), better);
    test = structure();
    if (progress) progress(0.5);
    if (test.p_value < fit_level && !pairs.empty()) {
      const std::vector<Fit> triples = searcher.extended(pairs, pair_seeds);
      fits.insert(fits.end(), triples.begin(), triples.end());
      std::sort(fits.begin(), fits.end(), better);
      test = structure();
    }
  }
  Findings findings;
  findings.noise = test.noise;
  for (Fit& one : fits) {
    Hypothesis hypothesis;
    hypothesis.log_likelihood = log_likelihood(measurements, one.residual, findings.noise);
    hypothesis.log_evidence = log_evidence(experiment, measurements, one, findings.noise);
    hypothesis.fit = std::move(one);
    findings.hypotheses.push_back(std::move(hypothesis));
  }
  std::sort(findings.hypotheses.begin(), findings.hypotheses.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.log_evidence > b.log_evidence; });
  if (progress) progress(1.0);
  return findings;
}

}  // namespace plumbline
