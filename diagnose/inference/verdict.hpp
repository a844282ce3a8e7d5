#pragma once
/// \file
/// From fitted hypotheses to a verdict: what stands out, what cannot be told apart, what is not explained.

#include "diagnose/inference/search.hpp"

namespace plumbline::diagnose {

enum class CauseVerdict { none, identified, ambiguous, unknown };

/// The word of the report.
std::string verdict_word(CauseVerdict verdict);

/// Why an explanation that stands out may not be the cause.
enum class Reservation {
  none,
  not_tested,        ///< no readings that could be held out carry a gap that it could shrink
  not_predicted,     ///< it does not predict the readings that were held out
  one_run,           ///< where it sets in shows in one run alone
  beyond_noise,      ///< it leaves more than the readings scatter, though no more than is tolerated
  small_gap,         ///< it takes two effects, and noise is much of the gap that it is tested on
  many_values,       ///< beside one effect it takes another with a value at every joint, link or run
  machining_alone,   ///< it is what machining leaves, or a kind of that, and nothing else
  beyond_tolerance,  ///< its tolerances are wider than machining leaves
  single_joint  ///< it draws the torque law of the only sprung joint, all but a part, and leaves more than
                ///< noise
};

/// Why, in words of which "it" is the explanation; empty for none.
std::string reservation_words(Reservation reservation);

/// A hypothesis with what was concluded of it.
struct Ranked {
  Hypothesis hypothesis;
  double probability;
  double chi2_per_dof;  ///< in the noise as it is, without outliers
};

struct Cause {
  CauseVerdict verdict = CauseVerdict::none;
  std::vector<Ranked> ranking;                  ///< most probable first
  Reservation reservation = Reservation::none;  ///< why the cause may be outside the catalogue nevertheless
  double unknown = 0;                           ///< probability that the cause is none of the ranking
  double remainder = 0;                 ///< share of the gap that a cause leaves beyond noise, held out
  std::size_t best = 0;                 ///< place of the best, for `unknown` of the best partial one
  std::vector<std::size_t> equivalent;  ///< places in the ranking that cannot be told apart from the best
};

/// Whether a hypothesis is what it says: none of its effects is switched off by a parameter at zero, or has
/// every parameter nearer to zero than the readings tell, and none has run to the end of a range where it
/// turns into another effect (a stop that always touches is a stiffer joint, a relaxation slower than the
/// experiment a stiffer spring), unless the readings hardly tell it from zero.
bool genuine(const Study& study, const Fit& fit);

/// The hypotheses that a search on fewer readings left standing, two at least, and those that are a part of
/// the leading one, fitted to all readings.
Findings confirmed(const Study& study, const Findings& found);

/// Chi-square per degree of freedom that a fit leaves in this noise, without outliers.
double chi2_per_dof(const Measurements& measurements, const Fit& fit, const NoiseModel& noise);

/// What a partial explanation costs, the less the better: what it leaves is taken as noise that eight
/// neighbouring readings share, and parameters are charged by Schwarz's criterion.
double partial_criterion(const Measurements& measurements, const Fit& fit);

/// Place of the explanation that is worth most where none is right, by partial_criterion().
std::size_t best_partial(const Measurements& measurements, const std::vector<const Fit*>& fits);

/// Makes the explanation at a place of the ranking the one that stands out, or the head of a class with those
/// that come near it; the cause is another with the given chance.
void settle_on(Cause& cause, std::size_t chosen, double unknown);

/// The best hypothesis is identified when it leaves no structure and no other comes near; ambiguous with
/// those that come near; unknown when it leaves structure.
Cause judge(const Study& study, const Findings& findings);

}  // namespace plumbline::diagnose
