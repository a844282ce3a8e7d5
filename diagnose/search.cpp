#include "diagnose/search.hpp"

#include <algorithm>

namespace plumbline {
namespace {

bool better(const Fit& a, const Fit& b) {
  return a.cost < b.cost;
}

/// How far a search goes. A pair is looked for from the fifteen best effects alone: in a gap with two causes
/// either is among them unless both are hidden behind more than a dozen that mimic their sum. A third effect
/// is looked for from the eight best pairs.
constexpr std::size_t single_seeds = 15, pair_seeds = 8;

class Searcher {
 public:
  Searcher(const Experiment& experiment, const Measurements& measurements)
      : experiment_(experiment), measurements_(measurements), places_(possible_effects(experiment)) {}

  [[nodiscard]] std::vector<Fit> singles() const {
    std::vector<Fit> fits;
    for (const EffectAt& at : places_)
      keep(fits, fit(experiment_, measurements_, Candidate{{at}}, settings_));
    std::sort(fits.begin(), fits.end(), better);
    return fits;
  }

  /// Adds one more effect to each of the best so far.
  [[nodiscard]] std::vector<Fit> extended(const std::vector<Fit>& from, std::size_t seeds) const {
    std::vector<Fit> fits;
    for (std::size_t s = 0; s < std::min(seeds, from.size()); ++s) {
      for (const EffectAt& at : places_) {
        Candidate candidate = from[s].candidate;
        if (std::count(candidate.effects.begin(), candidate.effects.end(), at) > 0) continue;
        candidate.effects.push_back(at);
        if (!holds(fits, candidate))
          keep(fits, refit_with(experiment_, measurements_, from[s], at, settings_));
      }
    }
    std::sort(fits.begin(), fits.end(), better);
    return fits;
  }

 private:
  static void keep(std::vector<Fit>& fits, Fit one) {
    if (one.converged) fits.push_back(std::move(one));
  }

  static bool holds(const std::vector<Fit>& fits, const Candidate& candidate) {
    return std::any_of(fits.begin(), fits.end(), [&](const Fit& one) {
      return std::is_permutation(one.candidate.effects.begin(), one.candidate.effects.end(),
                                 candidate.effects.begin(), candidate.effects.end());
    });
  }

  const Experiment& experiment_;
  const Measurements& measurements_;
  FitSettings settings_;
  std::vector<EffectAt> places_;
};

}  // namespace

Findings search(const Experiment& experiment, const Measurements& measurements,
                const std::function<void(double)>& progress) {
  const Searcher searcher(experiment, measurements);
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
