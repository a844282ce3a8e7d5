#pragma once
/// \file
/// An effect as a user states it, and the row that it becomes beside those of the catalogue.

#include "diagnose/inference/study.hpp"

namespace plumbline::diagnose {

struct StatedParameter {
  std::string name, unit;
  double scale, low, high;
  double tolerance;  ///< 0 where it has none

  /// Whether zero of it is nothing of the effect; others (where something begins, how fast it is) only shape
  /// it.
  [[nodiscard]] bool grows() const { return low <= 0; }
};

/// The correction of one channel's readings, or of all joint angles.
struct StatedReading {
  Channel::Name channel;
  std::optional<std::size_t> joint;  ///< from 0
  std::string key;                   ///< as the file has it
  std::shared_ptr<const Formula> formula;
};

/// Acts by a torque or by corrections of readings.
struct StatedEffect {
  std::string place;  ///< "FILE:LINE"
  std::string id;     ///< as the file has it
  std::string words;
  bool at_joint = false;
  std::shared_ptr<const Formula> torque;
  std::vector<StatedReading> readings;
  std::vector<StatedParameter> parameters;  ///< at least one that grows

  [[nodiscard]] bool uses(std::string_view variable) const;
};

/// Its row, whose id is user:NAME.
Effect row_of(std::shared_ptr<const StatedEffect> stated);

/// \throws Error where an expression has no value at a reading of the nominal model, or is not zero where all
///         that grows is, or names a joint that the chain does not have
void require_defined(const StatedEffect& stated, const Study& study);

/// A study in which these are looked for beside the effects of the catalogue, and which the nominal chain may
/// have among its own, each run on the side that its readings are on. \throws Error as require_defined() does
Study study_with(Experiment experiment, const std::vector<StatedEffect>& stated);

}  // namespace plumbline::diagnose
