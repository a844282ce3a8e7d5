#include "diagnose/inference/affordable.hpp"

#include <algorithm>
#include <cmath>

#include "diagnose/inference/prior.hpp"

namespace plumbline::diagnose {

bool affordable(const Study& study, const Candidate& candidate) {
  constexpr std::size_t most = 60;
  std::size_t free = 0, held = 0;
  for (const ParameterRange& range : study.ranges(candidate)) ++(range.tolerance > 0 ? held : free);
  return 3 * (free + std::min<std::size_t>(held, 1)) <= study.measurements().size() && free + held <= most;
}

double untested_share(const Study& study) {
  double share = 0;
  for (const EffectAt& at : possible_effects(study))
    if (const Candidate alone{{at}}; !affordable(study, alone)) share += std::exp(log_prior(study, alone));
  return share;
}

}  // namespace plumbline::diagnose
