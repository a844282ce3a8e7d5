#pragma once
/// \file
/// How far a rig repeats itself: logs of the same commands, gain and load.

#include <optional>

#include "diagnose/motion/motion_log.hpp"

namespace plumbline::motion {

/// Mean |difference of position| of logs that were commanded alike, rad; nothing where none were.
std::optional<double> repeatability(const std::vector<const MotionLog*>& logs);

}  // namespace plumbline::motion
