#pragma once
/// \file
/// An experiment beside the predictions of its nominal and corrected models: the contents of the charts.

#include "diagnose/answers/diagnosis.hpp"

namespace plumbline::diagnose {

struct Explained {
  Explained(const Study& studied, const Diagnosis& diagnosed);

  const Study& study;
  const Experiment& experiment;
  const Measurements& measurements;
  const Prediction& nominal;
  const Diagnosis& diagnosis;
  Prediction corrected;               ///< the nominal one where there is no explanation
  std::vector<double> before, after;  ///< residuals of both in declared sigmas, flat
  const Fit* best = nullptr;          ///< the best explanation, partial where the verdict is unknown
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

/// "a, b and c", for the separators ", " and " and ".
std::string joined(const std::vector<std::string>& parts, const std::string& between,
                   const std::string& last);

/// "play in joint 2 and the weight of the links"
std::string in_words(const Candidate& candidate);

/// "Fx, N".
std::string with_unit(const Channel& channel);

}  // namespace plumbline::diagnose
