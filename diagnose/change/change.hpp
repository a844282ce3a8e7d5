#pragma once
/// \file
/// The change of a device between two data sets.

#include <functional>

#include "diagnose/answers/diagnosis.hpp"
#include "diagnose/change/paired_states.hpp"

namespace plumbline::diagnose {

/// An effect is there now and was not, or the reverse; or its parameters tell the sense by their signs, and
/// are those of the later state relative to the earlier.
enum class Sense { added, removed, either };

struct Change {
  std::string before, after;           ///< names of the two experiments
  Sense sense;                         ///< of what the diagnosis names
  double sense_probability;            ///< of this sense
  Study study;                         ///< one state relative to the other
  Diagnosis diagnosis;                 ///< of that: its gap is the change
  std::vector<PairedRun> runs;         ///< of the state that is diagnosed
  std::vector<RankedCause> otherwise;  ///< causes in the other sense that are worth naming too
};

/// What changed from `before` to `after`. Either state is diagnosed relative to the other, for an effect of
/// the catalogue can come and go, and a row describes that it is there. The state of reference has the best
/// model that its own readings give, so that what changed acts on a device as it is; what that model lacks
/// cancels.
///
/// Both senses explain both states, by the probability of the state of reference times that of the other one
/// relative to it. Models of a reference differ in the share of the prior that they keep: an effect came
/// where the state before needs the simpler model. Where they leave more than noise, that counts less, as
/// evidence between causes does beside a discrepancy.
/// \param progress  called now and then with the share of the work that is done
/// \throws Error as relative_to and diagnose do
Change what_changed(const Study& before, const Study& after,
                    const std::function<void(double)>& progress = {});

/// The answer of a check after maintenance.
enum class Check { same = 0, changed = 1, cannot_tell = 2 };
/// It cannot tell where a change is neither probable nor improbable.
Check check(const Change& change);
/// \param probability  of a change
Check check_of(double probability);

}  // namespace plumbline::diagnose
