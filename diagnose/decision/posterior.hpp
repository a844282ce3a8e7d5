#pragma once
/// \file
/// Posterior probabilities of causes: of no gap, of each set of effects, and of a cause that the catalogue
/// does not have.

#include <string>
#include <vector>

#include "diagnose/inference/search.hpp"

namespace plumbline::diagnose {

/// A set of effects as a cause. Manufacturing tolerances beside it, and the forms of its effects (one value
/// for all joints or one at each, a number of elements), make no other cause.
struct CauseProbability {
  std::vector<std::string> labels;  ///< in alphabetical order
  double probability;
  std::size_t hypothesis;  ///< its most probable form, by its place in Findings::hypotheses
};

struct Posterior {
  double no_gap = 0;
  double outside = 0;
  std::vector<CauseProbability> causes;  ///< most probable first
  /// Probability that nothing is left beside the cause, whichever it is.
  double exact = 1;
  /// Power at which the likelihood counts: one where nothing is left, priors::temper where something is.
  double temper = 1;
};

/// A hypothesis beside an unknown torque is of the cause that its effects are where that torque is as small
/// as a discrepancy, and of a cause outside of the catalogue where it is not: in proportion to the priors of
/// its size.
Posterior posterior(const Study& study, const Findings& findings);

/// The share of the nominal residual, root mean squares, that a hypothesis leaves to discrepancy and unknown
/// torques.
double discrepancy_share(const Study& study, const Findings& findings, const Hypothesis& hypothesis);

}  // namespace plumbline::diagnose
