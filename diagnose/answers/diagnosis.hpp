#pragma once
/// \file
/// The whole diagnosis: is there a gap, where, what causes it, how far it shrinks.

#include <functional>
#include <optional>

#include "diagnose/answers/estimates.hpp"
#include "diagnose/answers/gap_answer.hpp"
#include "diagnose/decision/shrink.hpp"
#include "diagnose/decision/verdict.hpp"
#include "diagnose/design/next_run.hpp"
#include "diagnose/discrepancy/offered_law.hpp"
#include "diagnose/discrepancy/unexplained.hpp"

namespace plumbline::diagnose {

struct Diagnosis {
  std::string experiment;
  GapAnswer gap;
  Where where;
  Cause cause;
  NoiseModel noise;    ///< that the best explanation leaves
  NoiseModel allowed;  ///< what is named was let leave: the noise, of a single joint's law more
  std::vector<std::vector<Estimate>>
      estimates;                      ///< [effect of the best explanation][parameter]; of a known cause
  std::vector<EffectAt> not_excited;  ///< effects that these runs could not have shown
  std::optional<Shrink> shrink;
  /// For `unknown`: on readings held out neither a law nor the best partial explanation leaves less than the
  /// nominal model does, so that nothing is offered and there is no shrink.
  bool nothing_predicts = false;
  std::optional<OfferedLaw> law;    ///< where the cause may be unknown: a law that closes the gap
  std::optional<Missing> missing;   ///< for `unknown`: what is missing, without a catalogue
  std::vector<Proposal> proposals;  ///< for `ambiguous`, or on request: what to measure next

  /// Whether the law stands in for a cause: `shrink` is then the law's.
  [[nodiscard]] bool offers_law() const {
    return cause.verdict == CauseVerdict::unknown && law && law->shrink;
  }
  /// Whether the readings of some channel scatter so much, without a gap, that a ripple of the device finer
  /// than they are may be in it beside noise.
  [[nodiscard]] bool may_hide_ripple() const;
};

/// \param progress  called now and then with the share of the work that is done
/// \param plan      propose the next run even where the cause is not ambiguous: between the best two
/// \throws Error where the nominal model cannot follow the experiment
Diagnosis diagnose(const Study& study, const std::function<void(double)>& progress = {}, bool plan = false);

}  // namespace plumbline::diagnose
