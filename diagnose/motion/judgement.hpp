#pragma once
/// \file
/// From hypotheses to probabilities of causes, by the priors and losses of the diagnosis.

#include "diagnose/decision/verdict.hpp"
#include "diagnose/motion/search.hpp"

namespace plumbline::motion {

/// As of the diagnosis of benches. The evidence counts to the power `temper` where a discrepancy is beside
/// the causes. Of a cause of which a part changes the logs nearly as the whole does, the part is named.
diagnose::Posterior posterior(const Study& study, const Findings& findings);

}  // namespace plumbline::motion
