#pragma once
/// \file
/// What is missing, described without a catalogue: a torque at a joint, or a force or motion at the end
/// point.

#include "diagnose/answers/where.hpp"

namespace plumbline::diagnose {

/// One reading of what is missing.
struct MissingPoint {
  double at;     ///< joint angle, or the commanded coordinate that moves most
  double value;  ///< what is missing
  double t;      ///< since the start of the run
  bool falling;  ///< that angle or coordinate came down to it from the reading before
};

/// Everything that the experiment says about it.
struct Missing {
  std::string what, unit;  ///< "torque at joint 3", "N m"
  std::string against, against_unit;
  std::vector<MissingPoint> points;
  /// Shares of its variance that are a smooth function of the abscissa alone, of that and the direction of
  /// motion, and with a trend in time besides; none where readings are too few to tell.
  double by_position, by_direction, by_time;
};

/// The torque at the joint that has most of the missing torque, where joint angles are measured and one joint
/// has more than half of it; else the residual of the channel with the largest share.
Missing describe_missing(const Study& study, const NoiseEstimate& noise, const Where& where);

}  // namespace plumbline::diagnose
