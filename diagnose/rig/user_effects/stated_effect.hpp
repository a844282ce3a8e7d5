#pragma once
/// \file
/// A user effect, and its row beside those of the catalogue.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

struct StatedParameter {
  std::string name, unit;
  double scale, low, high;
  double tolerance;  ///< 0 where it has none

  /// Whether zero means no effect. Other parameters (thresholds, time constants) shape the effect.
  [[nodiscard]] bool grows() const { return low <= 0; }
};

/// A correction of the readings of one channel, or of all joint angles.
struct StatedReading {
  Channel::Name channel;
  std::optional<std::size_t> joint;  ///< from 0
  std::string key;                   ///< as the file has it
  std::shared_ptr<const Formula> formula;
};

/// A user effect: a torque, or corrections of readings.
struct StatedEffect {
  std::string place;  ///< "FILE:LINE"
  std::string id;     ///< as the file has it
  std::string words;
  bool at_joint = false;
  std::shared_ptr<const Formula> torque;
  std::vector<StatedReading> readings;
  std::vector<StatedParameter> parameters;  ///< at least one that grows
  std::vector<std::string> covariates;      ///< of the experiment: variables of every expression

  [[nodiscard]] bool uses(std::string_view variable) const;
};

/// The row of a user effect, with the id user:NAME.
Effect row_of(std::shared_ptr<const StatedEffect> stated);

/// \throws Error where an expression is undefined at a reading of the nominal model, is not zero where all
///         growing parameters are, or names a joint that the chain does not have
void require_defined(const StatedEffect& stated, const Study& study);

/// A study whose candidates include these effects; the nominal model may contain them too. Each run is
/// predicted on its observed branch.
/// \throws Error as require_defined() does
Study study_with(Experiment experiment, const std::vector<StatedEffect>& stated);

}  // namespace plumbline::diagnose
