#pragma once
/// \file
/// The verdict: the answer of least expected loss.

#include "diagnose/decision/posterior.hpp"

namespace plumbline::diagnose {

/// Partial: something outside of the catalogue acts beside what is named.
enum class CauseVerdict { none, identified, ambiguous, partial, unknown };

/// The word of the report.
std::string verdict_word(CauseVerdict verdict);

struct Verdict {
  CauseVerdict verdict = CauseVerdict::none;
  std::size_t named = 0;  ///< so many of Posterior::causes, the most probable ones
  /// Whether a cause outside of the catalogue is one of the answer's alternatives.
  bool or_outside = false;
  /// Whether causes of the catalogue leave nothing, and the readings are too few to tell them from one
  /// outside.
  bool too_few_readings = false;
};

/// There is a gap where that is more probable than not. Naming one cause more costs one, a cause that is not
/// named `priors::wrong_over_further_name`: every cause is named that is more probable than their ratio,
/// eight at most. A cause outside of the catalogue is one of them. Where it is more probable than all others
/// together the answer is `unknown`, unless one of them leaves nothing of the readings: these are then too
/// few.
Verdict decide(const Posterior& posterior);

}  // namespace plumbline::diagnose
