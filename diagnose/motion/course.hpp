#pragma once
/// \file
/// Commands that are not yet logged: courses over time, from zero.

#include <functional>
#include <string>

#include "diagnose/motion/motion_log.hpp"

namespace plumbline::motion {

/// A command over time.
struct Course {
  std::string words;                 ///< "a sine of 0.62 rad at 3 Hz"
  std::function<double(double)> at;  ///< rad, of a time in s
};

Course sine(double size, double hertz);
/// Half a second after the begin.
Course step(double size);
/// A sine whose frequency rises from zero.
Course sweep(double size, double highest, double duration);
/// Up in eight tenths of the duration, and back in the rest.
Course ramp(double size, double duration);

/// Time, commands and a drive that is on throughout; no readings, servo or load.
/// \param rate  of the commands, 1/s
MotionLog commanded(const Course& course, double duration, double rate, double supply);

}  // namespace plumbline::motion
