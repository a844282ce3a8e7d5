#include "diagnose/inference/idle.hpp"

#include <algorithm>
#include <optional>

namespace plumbline::diagnose {
namespace {

bool as_likely(const Study& study, const Likelihood& likelihood, const Instance& other, const Hypothesis& h) {
  constexpr double noticed = 1;  // nat
  const Prediction predicted = predict(study, other.candidate, other.parameters);
  if (!predicted.reached) return false;
  const VectorXd residual = study.residual(predicted);
  return residual.allFinite() && likelihood.look(residual).log_likelihood > h.look.log_likelihood - noticed;
}

/// The hypothesis with a thousandth of an effect; nothing where it has no strength that could be less.
std::optional<Instance> with_little_of(const Study& study, const Hypothesis& h, const EffectAt& effect) {
  Instance little{h.candidate, h.parameters};
  std::size_t p = 0;
  bool has_strength = false;
  for (const EffectAt& at : h.candidate.effects)
    for (const ParameterRange& range : study.ranges(at)) {
      const bool strength = at == effect && range.may_be_nothing();
      if (strength) little.parameters[p] *= 1e-3;
      has_strength = has_strength || strength;
      ++p;
    }
  return has_strength ? std::optional(little) : std::nullopt;
}

/// Whether the readings would show one of its parameters at its typical size.
bool shows_at_typical_size(const Study& study, const Hypothesis& h) {
  const std::vector<ParameterRange> ranges = study.ranges(h.candidate);
  for (std::size_t p = 0; p < ranges.size(); ++p) {
    const auto k = static_cast<Eigen::Index>(p);
    if (h.look.information(k, k) * ranges[p].scale * ranges[p].scale > 1) return true;
  }
  return false;
}

}  // namespace

bool has_idle_effect(const Study& study, const Likelihood& likelihood, const Hypothesis& h) {
  if (h.candidate.effects.size() == 1)
    return !h.candidate.effects.front().effect->outside && !shows_at_typical_size(study, h);
  return std::any_of(h.candidate.effects.begin(), h.candidate.effects.end(), [&](const EffectAt& gone) {
    if (h.candidate.has_as_tolerance(gone)) return false;
    const Instance rest =
        part(study, h.candidate, h.parameters, [&](const EffectAt& at) { return !(at == gone); });
    if (as_likely(study, likelihood, rest, h)) return true;
    const std::optional<Instance> little = with_little_of(study, h, gone);
    return little && as_likely(study, likelihood, *little, h);
  });
}

}  // namespace plumbline::diagnose
