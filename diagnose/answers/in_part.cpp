#include "diagnose/answers/in_part.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "diagnose/decision/cross_validation.hpp"
#include "diagnose/decision/smooth_forecast.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

/// The leading hypothesis with the effects that are part of the cause, whichever else acts; no effect where
/// none is.
Instance certain_part(const Study& study, const Findings& findings, const Posterior& posterior) {
  if (posterior.leading == Way::none) return {};
  const Hypothesis& leading = findings.hypotheses[posterior.leading];
  return part(study, leading.candidate, leading.parameters, [&](const EffectAt& at) {
    const auto found = posterior.effects.find(at.label());
    return !at.effect->outside && found != posterior.effects.end() && found->second >= priors::part_of_it;
  });
}

double least_probability(const Posterior& posterior, const Candidate& candidate) {
  double least = 1;
  for (const EffectAt& at : candidate.effects) least = std::min(least, posterior.effects.at(at.label()));
  return least;
}

}  // namespace

std::optional<InPart> in_part(const Study& study, const Findings& findings, const Posterior& posterior,
                              const NoiseEstimate& noise) {
  const Instance certain = certain_part(study, findings, posterior);
  if (certain.candidate.effects.empty()) return std::nullopt;
  Hypothesis fitted =
      maximised(study, *findings.likelihood, certain.candidate, certain.parameters, Effort{6, 0.03});
  if (!fitted.converged) return std::nullopt;
  const std::optional<Shrink> shrink = cross_validated(study, findings, noise, fitted);
  if (!shrink || !shrink->tested() || shrink->ratio_high >= 1) return std::nullopt;
  const std::optional<Shrink> smooth = smooth_forecast(study, noise);
  if (smooth && smooth->ratio <= shrink->ratio) return std::nullopt;
  const double chi2 = chi2_per_value(study, noise, fitted.residual);
  return InPart{{std::move(fitted), certain.candidate, least_probability(posterior, certain.candidate), chi2},
                {shrink->ratio, shrink->noise_floor_ratio, "the rest is outside the catalogue"},
                shrink};
}

std::optional<Rest> rest_of(const RankedCause& cause, const NoiseEstimate& noise,
                            const std::optional<Shrink>& shrink, double nominal_chi2) {
  const bool tested = shrink && shrink->tested();
  Rest rest{tested ? shrink->ratio : std::sqrt(cause.chi2_per_value / std::max(nominal_chi2, 1e-300)),
            tested ? shrink->noise_floor_ratio : std::min(1.0, 1 / std::sqrt(std::max(nominal_chi2, 1e-300))),
            ""};
  if (tested && shrink->ratio_low > std::max(priors::whole_cause_leaves, 2 * shrink->noise_floor_ratio)) {
    rest.why = "the rest is outside the catalogue";
    return rest;
  }
  double scale = 0;
  for (const ChannelNoise& one : noise.channels) scale = std::max(scale, one.scale);
  if (scale > priors::scatter) {
    rest.why = fmt::format("what it leaves scatters by {:.2g} times the declared noise", scale);
    return rest;
  }
  const std::vector<bool>& held = cause.hypothesis.at_bound;
  for (std::size_t p = 0; p < held.size(); ++p)
    if (held[p] && cause.hypothesis.parameters[p] != 0) {
      rest.why = "a value stands at the end of its range";
      return rest;
    }
  return std::nullopt;
}

}  // namespace plumbline::diagnose
