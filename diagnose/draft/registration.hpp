#pragma once
/// \file
/// The frame and the unit in which places of an arm's tip were read.

#include <string>
#include <vector>

#include "diagnose/draft/arm_run.hpp"

namespace plumbline::diagnose {

struct Registration {
  std::string unit;               ///< of the places
  bool said = false;              ///< whether the tables say the unit
  Pose<double> frame;             ///< of the model's world in that of the tracker, m
  double as_read, as_registered;  ///< rms distance from the nominal tip, m
  bool takes_frame = false;       ///< whether the tracker's world is clearly another than the model's
};

/// Places over all runs against those of the nominal tip at the commands. Distances among places do not know
/// the frame, and tell the unit; the frame is the rigid motion of least squares (S. Umeyama, IEEE PAMI 13,
/// 1991). Two coordinates, or fewer than four places, have their unit alone.
Registration registered(const std::vector<ArmRun>& runs, const NominalArm& arm);

}  // namespace plumbline::diagnose
