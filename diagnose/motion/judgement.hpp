#pragma once
/// \file
/// From hypotheses to probabilities of causes, by the priors and losses of the diagnosis.

#include "diagnose/decision/verdict.hpp"
#include "diagnose/motion/search.hpp"

namespace plumbline::motion {

/// As of the diagnosis of benches. The evidence counts to the power `temper` where a discrepancy is beside
/// the causes.
diagnose::Posterior posterior(const Findings& findings);

}  // namespace plumbline::motion
