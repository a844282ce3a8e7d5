#pragma once
/// \file
/// The fewest of many runs that tell all explanations apart: a cover in which runs help each other.

#include <vector>

#include "diagnose/design/separation.hpp"

namespace plumbline::diagnose {

/// One explanation that is true and one that imitates it: the rows of each run, under the same parameters.
using Contrast = std::vector<LinearisedAlternative>;

/// Expected lead of the true explanation with some of the runs, in log-likelihood: half of what the other
/// cannot imitate in all of them at once. Never less with more runs.
double expected_log_likelihood_ratio(const Contrast& contrast, const std::vector<std::size_t>& runs);

/// Whether so few of the runs, the most telling ones taken one after the other, let every contrast lead by
/// more than `enough`.
bool few_suffice(const std::vector<Contrast>& contrasts, std::size_t count, double enough, std::size_t few);

struct FewestRuns {
  std::vector<std::size_t> runs;  ///< the most telling first
  bool proved =
      false;  ///< no set of one run fewer suffices: so no smaller one, for less runs never lead by more
};

/// The fewest runs with which every contrast leads by more than `enough`. Greedily, the run next that brings
/// the contrasts farthest on their way, without those that turn out to be superfluous; then all sets of one
/// fewer are tried, and of one fewer again where one suffices, up to a limit.
/// \param contrasts  each leads by more than `enough` with all runs together
/// \param count      of the runs; at least one
FewestRuns fewest_runs(const std::vector<Contrast>& contrasts, std::size_t count, double enough);

}  // namespace plumbline::diagnose
