#pragma once
/// \file
/// The fewest runs that, made again, would show a change of a stated size.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

/// A run that is made again.
struct Repeat {
  std::string run;
  double evidence;  ///< expected logarithm of the likelihood ratio of the change over none
};

struct ChangePlan {
  std::string experiment, change;   ///< "joint_friction", in words
  std::vector<std::string> values;  ///< "tau_c = 0.05 N m"
  std::vector<Repeat> runs;         ///< those that tell most first
  /// So many of these show the change; zero where all of them do not.
  std::size_t fewest = 0;
  /// The smallest change that all of them show, over the stated one.
  double least = 0;
};

/// A change is shown where its expected evidence over no change exceeds `told_apart`: the likelihood ratio,
/// by the prior of the effect and by the share of its parameters' prior that the readings leave. The noise is
/// that of a difference; the lack of the model cancels. To make a run twice adds little, for the readings of
/// the reference stay as they are.
/// \param bench   of which the commands count
/// \param change  "EFFECT=VALUE,…": of "joint_friction" or "joint_stop(2)", its parameters in their units
/// \throws Error for another effect, for values that it cannot have, or where the chain cannot follow it
ChangePlan plan_of_change(const Experiment& bench, const std::string& change);

std::string as_text(const ChangePlan& plan);
/// Format "change-plan/1".
nlohmann::ordered_json as_json(const ChangePlan& plan);

}  // namespace plumbline::diagnose
