#pragma once
/// \file
/// A look at logs before any fit: rates, quanta, motion; and what no fit can begin with.

#include "diagnose/motion/motion_log.hpp"

namespace plumbline::motion {

/// Over all logs.
struct LogsLook {
  std::size_t logs = 0, readings = 0;
  double step = 0, step_low = 0, step_high = 0;  ///< between readings: median, 1 and 99 per cent, s
  double quantum = 0;                            ///< least change of position that occurs, rad
  double saturated = 0;  ///< share of the powered readings whose error asks for the whole duty
  double off = 0;        ///< share of the readings without power
  std::size_t spikes = 0;
};

/// Replaces isolated readings of position, far from neighbours that agree, by the mean of the nearest two.
/// \param sigma  standard deviation of a reading, rad
void mend_spikes(MotionLog& log, double sigma);

LogsLook look_at(const std::vector<MotionLog>& logs);

/// \throws Error for a log that cannot be judged: too short, a clock that runs back or stands, a joint that
///         never moves or leaves its command at once, a drive that is saturated all along
void require_judgeable(const MotionLog& log);

}  // namespace plumbline::motion
