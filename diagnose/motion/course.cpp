#include "diagnose/motion/course.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::motion {

using std::numbers::pi;

Course sine(double size, double hertz) {
  return {fmt::format("a sine of {:.2g} rad at {:g} Hz", size, hertz),
          [=](double t) { return size * std::sin(2 * pi * hertz * t); }};
}

Course step(double size) {
  return {fmt::format("a step of {:.2g} rad", size), [=](double t) { return t < 0.5 ? 0 : size; }};
}

Course sweep(double size, double highest, double duration) {
  return {fmt::format("a sweep of {:.2g} rad from 0 to {:g} Hz", size, highest),
          [=](double t) { return size * std::sin(pi * highest / duration * t * t); }};
}

Course ramp(double size, double duration) {
  const double up = 0.8 * duration, back = duration - up;
  return {fmt::format("a ramp to {:.2g} rad in {:g} s, and back in {:g} s", size, up, back),
          [=](double t) { return t < up ? size * t / up : size * std::max(0.0, 1 - (t - up) / back); }};
}

MotionLog commanded(const Course& course, double duration, double rate, double supply) {
  MotionLog log;
  log.name = course.words;
  const auto readings = static_cast<std::size_t>(std::round(duration * rate));
  for (std::size_t k = 0; k < readings; ++k) {
    log.time.push_back(static_cast<double>(k) / rate);
    log.command.push_back(course.at(log.time.back()));
  }
  log.supply.assign(readings, supply);
  log.powered.assign(readings, true);
  return log;
}

}  // namespace plumbline::motion
