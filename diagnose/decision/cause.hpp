#pragma once
/// \file
/// What is concluded of a gap's cause.

#include "diagnose/inference/search.hpp"

namespace plumbline::diagnose {

enum class CauseVerdict { none, identified, ambiguous, unknown };

/// The word of the report.
std::string verdict_word(CauseVerdict verdict);

/// Why an explanation that stands out may not be the cause.
enum class Reservation {
  none,
  not_tested,       ///< no readings that could be held out carry a gap that it could shrink
  not_predicted,    ///< it does not predict the readings that were held out
  one_run,          ///< where it sets in shows in one run alone
  beyond_noise,     ///< it leaves more than the readings scatter, though no more than is tolerated
  small_gap,        ///< it takes two effects, and noise is much of the gap that it is tested on
  many_values,      ///< beside one effect it takes another with a value at every joint, link or run
  machining_alone,  ///< it is what machining leaves, or a kind of that, and nothing else
  shape_alone,      ///< it says how a torque goes with the angle, as laws that nobody listed go too
  many_times,       ///< it relaxes in three times, as what relaxes by a power of time is drawn too
  load_alone,       ///< it rubs by the load alone, as a pulley does too
  camera,  ///< it turns or scales all that is seen of a chain under forces, as a camera does that is off
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

}  // namespace plumbline::diagnose
