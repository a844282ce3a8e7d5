#pragma once
/// \file
/// The verdict: the answer of least expected loss.

#include "diagnose/decision/posterior.hpp"

namespace plumbline::diagnose {

enum class CauseVerdict { none, identified, ambiguous, unknown };

/// The word of the report.
std::string verdict_word(CauseVerdict verdict);

struct Verdict {
  CauseVerdict verdict = CauseVerdict::none;
  std::size_t named = 0;  ///< so many of Posterior::causes, the most probable ones
  /// Whether a cause outside of the catalogue is one of the answer's alternatives.
  bool or_outside = false;
};

/// There is a gap where that is more probable than not. Naming one cause more costs one, a cause that is not
/// named `priors::wrong_over_further_name`: every cause is named that is more probable than their ratio. A
/// cause outside of the catalogue is one of them; where it is more probable than all others together, or more
/// of them would have to be named than help anybody, the answer is `unknown`.
Verdict decide(const Posterior& posterior);

}  // namespace plumbline::diagnose
