#pragma once
/// \file
/// The whole diagnosis: is there a gap, where, what causes it, how far it shrinks.

#include <functional>
#include <map>
#include <optional>

#include "diagnose/answers/next_run.hpp"
#include "diagnose/answers/offered_law.hpp"
#include "diagnose/answers/shrink.hpp"
#include "diagnose/answers/unexplained.hpp"
#include "diagnose/inference/verdict.hpp"

namespace plumbline::diagnose {

/// A tone in one channel of one run that was taken for noise.
struct HummingChannel {
  std::string run;
  Channel channel;
  double period;  ///< readings
  double rms;     ///< declared sigmas
};

/// A run whose chain went to the other side than its nominal model goes to by itself.
struct OtherSide {
  std::string run;
  std::size_t reading;  ///< as it was taken, from 0: the first one there
};

/// A run in which a sensor scatters more than in the others, and how many times.
struct RougherRun {
  std::string run;
  Sensor sensor;
  double times;
};

struct GapAnswer {
  bool present;
  GapTest test;
  double chi2_per_value;          ///< of the nominal residual, in the noise as it is
  std::map<Channel, double> rms;  ///< of the nominal residual by channel, in its unit
  std::vector<HummingChannel> hum;
  /// Of channels that scatter in proportion to their readings: the share of the reading, beside the rest.
  std::map<Channel::Name, double> proportional;
  /// Of joints whose angles scatter more than those of the others: how many times.
  std::map<Channel, double> uneven;
  std::vector<RougherRun> rougher;
  /// Runs whose forces were taken for those of weights, since they look like it (Run::weights_inferred).
  std::vector<std::string> taken_for_weights;
  std::vector<OtherSide> other_side;
};

/// A parameter of the best explanation with its 95 % bounds, in catalogue units.
struct Estimate {
  std::string name, unit;
  double value, low, high;
  bool at_bound;
};

/// Puts elements of so many parameters each that may change places in the order of the last of them; the
/// names stay where they are.
void put_in_order(std::vector<Estimate>& estimates, std::size_t element);

struct Diagnosis {
  std::string experiment;
  GapAnswer gap;
  Where where;
  Cause cause;
  NoiseModel noise;    ///< that the best explanation leaves
  NoiseModel allowed;  ///< what is named was let leave: the noise, of a single joint's law more
  std::vector<std::vector<Estimate>>
      estimates;                        ///< [effect of the best explanation][parameter]; of a known cause
  std::vector<EffectAt> not_exercised;  ///< effects that these runs could not have shown
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
