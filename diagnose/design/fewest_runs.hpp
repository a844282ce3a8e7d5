#pragma once
/// \file
/// The smallest set of runs that distinguishes all hypotheses.

#include <vector>

#include "diagnose/design/separation.hpp"

namespace plumbline::diagnose {

/// A true hypothesis and an alternative: one block of rows a run, with common parameters.
using Contrast = std::vector<LinearisedAlternative>;

/// The expected log-likelihood ratio of the truth over the refitted alternative, with some of the runs. It
/// does not decrease with more runs.
double expected_log_likelihood_ratio(const Contrast& contrast, const std::vector<std::size_t>& runs);

/// Whether the first `few` runs of the greedy choice give every contrast an expected log-likelihood ratio
/// above `enough`.
bool few_suffice(const std::vector<Contrast>& contrasts, std::size_t count, double enough, std::size_t few);

struct FewestRuns {
  std::vector<std::size_t> runs;  ///< in the order of their contribution
  bool proved = false;            ///< no smaller set suffices
};

/// A smallest set of runs with which every contrast exceeds `enough`: a greedy choice, pruned, followed by an
/// exhaustive search among all sets with one run fewer, repeated while it succeeds and up to a limit of work.
/// \param contrasts  each exceeds `enough` with all runs together
/// \param count      number of runs, at least one
FewestRuns fewest_runs(const std::vector<Contrast>& contrasts, std::size_t count, double enough);

}  // namespace plumbline::diagnose
