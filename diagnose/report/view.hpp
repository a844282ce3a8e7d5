#pragma once
/// \file
/// An experiment beside the predictions of its nominal and corrected models: the contents of the charts.

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

/// An effect of the leading cause. Manufacturing tolerances beside other effects are none.
struct EstimatedEffect {
  EffectAt at;
  std::vector<Estimate> values;
};
/// Empty where no cause is known.
std::vector<EstimatedEffect> estimated_effects(const Diagnosis& diagnosis);

/// Whether manufacturing tolerances show beside the effects of a cause.
bool shows_tolerances(const RankedCause& cause);

/// Whether a cause outside the catalogue is an alternative that is more probable than the leading cause.
bool outside_is_likelier(const Cause& cause);

/// So many of Cause::effects are worth telling: the few most probable ones, where the cause is not
/// identified.
std::size_t told_effects(const Cause& cause);
/// "dry friction in joint 2"; the label of an effect that no listed cause has.
std::string effect_in_words(const Cause& cause, const std::string& label);

/// The model whose residual reduction was measured: "this cause", "the torque law", ...
std::string tested_model(const Diagnosis& diagnosis);

struct Explained {
  Explained(const Study& studied, const Diagnosis& diagnosed);

  const Study& study;
  const Experiment& experiment;
  const Measurements& measurements;
  const Prediction& nominal;
  const Diagnosis& diagnosis;
  Prediction corrected;               ///< the nominal one where there is no explanation
  VectorXd before, after;             ///< residuals of both in declared sigmas, flat
  const RankedCause* best = nullptr;  ///< the most probable cause; none without a gap
  std::string model;  ///< the name of `corrected`: "corrected model", "best partial explanation", ...

  [[nodiscard]] const Series& series(std::size_t place) const { return measurements.series()[place]; }
};

/// The held-out readings; empty where there are none, or where every reading is held out in turn.
HeldOut heldout_of(const Explained& explained);

/// The command along the path of a run: its distance from the first reading, in the direction of the farthest
/// one.
struct Command {
  std::vector<double> along;  ///< by reading, m or N
  std::string label;          ///< "end point moved along −x, m"
  std::size_t farthest;       ///< reading
};
Command command_of(const Run& run);

/// "0.912", "> 0.999", "< 0.001".
std::string probability_in_words(double value);

/// "a, b and c", for the separators ", " and " and ".
std::string joined(const std::vector<std::string>& parts, const std::string& between,
                   const std::string& last);

/// "play in joint 2 and the weight of the links"
std::string in_words(const Candidate& candidate);

/// "Fx, N".
std::string with_unit(const Channel& channel);

}  // namespace plumbline::diagnose
