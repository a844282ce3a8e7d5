#pragma once
/// \file
/// The whole diagnosis: is there a gap, where, what causes it, how far it shrinks.

#include <functional>
#include <optional>

#include "diagnose/answers/cause.hpp"
#include "diagnose/answers/estimates.hpp"
#include "diagnose/answers/gap.hpp"
#include "diagnose/answers/offered_law.hpp"
#include "diagnose/answers/unexplained.hpp"
#include "diagnose/answers/where.hpp"
#include "diagnose/decision/shrink.hpp"
#include "diagnose/design/next_run.hpp"

namespace plumbline::diagnose {

struct Diagnosis {
  std::string experiment;
  GapAnswer gap;
  Where where;
  Cause cause;
  NoiseEstimate noise;  ///< that the leading cause leaves
  std::vector<std::vector<Estimate>>
      estimates;                      ///< [effect of the leading hypothesis][parameter]; of a known cause
  std::vector<EffectAt> not_excited;  ///< effects that these runs could not have shown
  std::optional<Shrink> shrink;
  /// Whether the leading cause was dropped: it does not predict readings that its fit has not seen.
  bool fails_to_predict = false;
  std::optional<OfferedLaw> law;         ///< where the cause may be unknown: a law that closes the gap
  std::optional<Missing> missing;        ///< for `unknown`: what is missing, without a catalogue
  std::vector<Proposal> proposals;       ///< for `ambiguous`, or on request: what to measure next
  std::vector<std::string> joints = {};  ///< names that the model of an arm has for them; empty without
  std::shared_ptr<const Calibration> calibration = nullptr;  ///< beside which the causes stand, or none
  double assumed_density = 0;  ///< of links without masses in their model, kg/m; 0 where these have some

  /// Whether the law stands in for a cause, or for what a part of it leaves: `shrink` is then the law's.
  [[nodiscard]] bool offers_law() const { return cause.leaves_a_rest() && law && law->shrink; }
};

/// \param progress  called now and then with the share of the work that is done
/// \param plan      propose the next run even where the cause is not ambiguous: between the best two
/// \throws Error where the nominal model cannot follow the experiment
Diagnosis diagnose(const Study& study, const std::function<void(double)>& progress = {}, bool plan = false);

}  // namespace plumbline::diagnose
