#pragma once
/// \file
/// The change of a joint in motion between two sets of logs.

#include <functional>
#include <string>
#include <vector>

#include "diagnose/change/change.hpp"
#include "diagnose/motion/diagnosis.hpp"

namespace plumbline::diagnose {

/// A log of one state, held against one of the other state that took the same commands at the same rate.
struct PairedLog {
  std::string log;
  std::string reference;  ///< empty where none took them
  double offset;          ///< of its clock against that of the reference, s
};

/// The logs of a state, less what the model of the reference lacks under the same commands: y - (y' - f').
struct RelativeLogs {
  motion::Bench bench;  ///< whose nominal drive is that of the reference
  std::vector<PairedLog> logs;
  /// Whether the lack of the model cancels. Where no log has a counterpart all are compared, and the lack
  /// counts as noise.
  bool cancels = false;
};

/// \param spread  of what the model of the reference leaves of its logs, standard deviation, rad
RelativeLogs relative_to(const motion::Bench& reference, const motion::Drive<double>& drive, double spread,
                         const motion::Bench& state);

struct MotionChange {
  std::string before, after;
  Sense sense;                  ///< of what the diagnosis names
  motion::Diagnosis diagnosis;  ///< of one state relative to the other: its gap is the change
  RelativeLogs relative;
};

/// What changed from `before` to `after`. Either state is diagnosed relative to the other one, whose drive is
/// the best that its own logs give; the sense is the one whose first cause is the more probable.
/// \param progress  called now and then with the share of the work that is done
/// \throws Error where loads or servos of the two are stated differently, or as the diagnosis of logs does
MotionChange what_changed(const motion::Bench& before, const motion::Bench& after,
                          const std::function<void(double)>& progress = {});

Check check(const MotionChange& change);

}  // namespace plumbline::diagnose
