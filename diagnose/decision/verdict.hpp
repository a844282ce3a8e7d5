#pragma once
/// \file
/// From fitted hypotheses to a verdict: what stands out, what cannot be told apart, what is not explained.

#include "diagnose/decision/cause.hpp"

namespace plumbline::diagnose {

/// The hypotheses that a search on fewer readings left standing, two at least, and those that are a part of
/// the leading one, fitted to all readings.
Findings confirmed(const Study& study, const Findings& found);

/// What a partial explanation costs, the less the better: what it leaves is taken as noise that eight
/// neighbouring readings share, and parameters are charged by Schwarz's criterion.
double partial_criterion(const Measurements& measurements, const Fit& fit);

/// Place of the explanation that is worth most where none is right, by partial_criterion().
std::size_t best_partial(const Measurements& measurements, const std::vector<const Fit*>& fits);

/// The best hypothesis is identified when it leaves no structure and no other comes near; ambiguous with
/// those that come near; unknown when it leaves structure.
Cause judge(const Study& study, const Findings& findings);

}  // namespace plumbline::diagnose
