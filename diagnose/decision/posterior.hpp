#pragma once
/// \file
/// Posterior probabilities of causes: of no gap, of each set of effects, and of a cause that the catalogue
/// does not have.

#include <map>
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
  /// By each more probable cause that could be named: the share of what this cause changes in the readings
  /// that the other leaves, where the other is a part of this one. It is one where it is none, or past the
  /// end.
  std::vector<double> left = {};
};

/// One way in which the readings may have come about.
struct Way {
  enum class Of { nothing, listed, outside } of;
  std::size_t
      hypothesis;  ///< by its place in Findings::hypotheses; nothing but noise, or a cause outside: none
  double log_prior;
  double log_evidence;  ///< marginal likelihood: all that is not known summed out
  /// Variance of the discrepancy beside it over that of the noise, one at most.
  double discrepancy;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
};

/// All of them, the nominal model and noise first.
///
/// A hypothesis beside an unknown torque, or a scatter, is of the cause that its effects are where that is as
/// small as a discrepancy, and of a cause outside of the catalogue where it is not: in proportion to the
/// priors of its size.
std::vector<Way> ways(const Study& study, const Findings& findings);

/// Whether there is a gap, by the evidence as it is, and how probable each way of a gap is.
struct GapPosterior {
  double no_gap = 0;
  double log_odds_of_gap = 0;  ///< over no gap
  /// Probability of the explanations of a gap for which the readings speak: with them they are more probable
  /// than with noise alone. A gap may be too small to be seen.
  double seen_gap = 0;
  /// Power at which the evidence counts between causes: one where no discrepancy is beside them.
  double temper = 1;
};

struct Weighed {
  GapPosterior gap;
  std::vector<double> probability;  ///< of all ways but the first, by the evidence to the power of the temper
};

/// \param all  the nominal model and noise first
Weighed weigh(const std::vector<Way>& all);

struct Posterior : GapPosterior {
  double outside = 0;
  std::vector<CauseProbability> causes;  ///< most probable first
  /// By label: that an effect is part of the cause, whether or not something outside of the catalogue is too.
  std::map<std::string, double> effects;
  /// The fewest effects of which one at least is surely part of the cause (`priors::part_of_it`), the most
  /// probable first; none where many would be needed.
  std::vector<std::string> surely_part;
  /// The hypothesis of the most probable way in which effects of the catalogue act; Way::none without any.
  std::size_t leading = Way::none;
  /// Whether nothing but noise near the declared one is left beside the most probable cause of the catalogue.
  bool leaves_nothing = false;
};

/// Whether there is a gap is decided by the evidence as it is; what its cause is by the evidence to the power
/// Posterior::temper, since neighbouring readings share a discrepancy.
Posterior posterior(const Study& study, const Findings& findings);

/// The share of the nominal residual, root mean squares, that a hypothesis leaves to discrepancy and unknown
/// torques.
double discrepancy_share(const Study& study, const Findings& findings, const Hypothesis& hypothesis);

}  // namespace plumbline::diagnose
