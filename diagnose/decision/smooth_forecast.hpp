#pragma once
/// \file
/// Whether a cause says more of readings that its fit has not seen than a smooth function of the command, its
/// direction and the run does: what a cause that is named in part has to.

#include <optional>

#include "diagnose/decision/cross_validation.hpp"

namespace plumbline::diagnose {

/// How far a hypothesis with a smooth function beside it shrinks what the smooth function alone leaves: the
/// discrepancy, of its most probable size and length by channel.
std::optional<Shrink> gain_over_smooth(const Study& study, const Findings& findings,
                                       const NoiseEstimate& noise, const Hypothesis& hypothesis);

}  // namespace plumbline::diagnose
