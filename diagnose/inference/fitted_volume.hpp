#pragma once
/// \file
/// The share of its prior's volume that the readings leave to a fitted hypothesis, by Laplace's method, and
/// the effects that they speak for.

#include <vector>

#include "diagnose/inference/hypothesis.hpp"

namespace plumbline::diagnose {

/// Logarithm of that share, the sizes of effects summed out.
double log_volume(const Study& study, const Hypothesis& hypothesis);

/// Effects that stay of a hypothesis, and the share of its evidence in which they do.
struct SeenEffects {
  Candidate candidate;
  double share;
};

/// Divides the evidence of a hypothesis by the sizes of its effects: an effect is seen at a size where the
/// readings are more probable with it than with none of the effect. All stay where none is seen.
std::vector<SeenEffects> seen_effects(const Study& study, const Hypothesis& hypothesis);

}  // namespace plumbline::diagnose
