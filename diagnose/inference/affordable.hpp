#pragma once
/// \file
/// Which hypotheses an experiment has readings enough to test.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// Whether there are three readings for each parameter, and sixty parameters at most. Those with Gaussian
/// priors count as one.
bool affordable(const Study& study, const Candidate& candidate);

/// Probability, given a cause of the catalogue, of a single one that takes more readings than there are.
double untested_share(const Study& study);

}  // namespace plumbline::diagnose
