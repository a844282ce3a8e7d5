#include "diagnose/answers/in_part.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "diagnose/decision/cross_validation.hpp"
#include "diagnose/decision/smooth_forecast.hpp"
#include "diagnose/priors.hpp"

namespace plumbline::diagnose {
namespace {

double probability_of(const Posterior& posterior, const EffectAt& at) {
  const auto found = posterior.effects.find(at.label());
  return found == posterior.effects.end() ? 0 : found->second;
}

/// The most probable hypothesis that holds an effect, without what is not surely part of the cause.
std::optional<RankedCause> part_with(const Study& study, const Findings& findings, const Posterior& posterior,
                                     const NoiseEstimate& noise, const std::string& label) {
  const auto holds = [&](const Hypothesis& h) {
    return std::any_of(h.candidate.effects.begin(), h.candidate.effects.end(), [&](const EffectAt& at) {
      return at.label() == label && !h.candidate.has_as_tolerance(at);
    });
  };
  const auto best = std::find_if(findings.hypotheses.begin(), findings.hypotheses.end(), holds);
  if (best == findings.hypotheses.end()) return std::nullopt;
  const Instance sure = part(study, best->candidate, best->parameters, [&](const EffectAt& at) {
    return !at.effect->outside &&
           (at.label() == label || probability_of(posterior, at) >= priors::part_of_it);
  });
  Hypothesis fitted =
      maximised(study, *findings.likelihood, sure.candidate, sure.parameters, Effort{6, 0.03});
  if (!fitted.converged) return std::nullopt;
  double least = 1;
  for (const EffectAt& at : sure.candidate.effects) least = std::min(least, probability_of(posterior, at));
  const double chi2 = chi2_per_value(study, noise, fitted.residual);
  return RankedCause{std::move(fitted), sure.candidate, least, chi2};
}

}  // namespace

std::optional<InPart> in_part(const Study& study, const Findings& findings, const Posterior& posterior,
                              const NoiseEstimate& noise) {
  InPart found;
  for (const std::string& label : posterior.surely_part)
    if (std::optional<RankedCause> one = part_with(study, findings, posterior, noise, label))
      found.causes.push_back(*std::move(one));
  std::optional<Shrink> gain;
  const auto first = std::find_if(found.causes.begin(), found.causes.end(), [&](const RankedCause& one) {
    gain = gain_over_smooth(study, findings, noise, one.hypothesis);
    return gain && gain->ratio_high < 1;
  });
  if (first == found.causes.end()) return std::nullopt;
  std::rotate(found.causes.begin(), first, first + 1);
  found.shrink = cross_validated(study, findings, noise, found.causes.front().hypothesis);
  found.rest.why = fmt::format(
      "beside a smooth function of the command it leaves {:.0f} % of what that function alone leaves of "
      "unseen "
      "readings; the rest is outside the catalogue",
      100 * gain->ratio);
  found.rest.share = found.shrink ? std::min(1.0, found.shrink->ratio) : 1;
  found.rest.noise_floor = found.shrink ? found.shrink->noise_floor_ratio : gain->noise_floor_ratio;
  return found;
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
