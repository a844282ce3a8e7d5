#pragma once
/// \file
/// A look at readings beside position before any fit: whether they are readings, and what the log itself
/// shows of the same quantity.

#include <string>

#include "diagnose/motion/motion_log.hpp"

namespace plumbline::motion {

/// Of one channel, over all logs.
struct ChannelLook {
  Channel channel;
  double refresh = 0;    ///< mean time between changes, s
  double ratio = 0;      ///< over what the log shows (ChannelKind::of), by least squares
  double late = 0;       ///< age of what explains it best, s; negative where it is ahead
  double explained = 0;  ///< share of the channel's variance that this explains
  std::string left_out;  ///< why it is no reading; empty where it is one
};

std::vector<ChannelLook> look_beside(const std::vector<MotionLog>& logs);

}  // namespace plumbline::motion
